#pragma once

#include <tsl/robin_map.h>

#include <vector>

#include "evaluation/confusion.hpp"
#include "stillmap/voxel_key.hpp"

namespace stillmap {

/// Map-wise counting: a point counts as retained when the output map has a point within half a voxel of it.
/// The output map is made of all points that were not removed. First every removed point, then the kept ones.
class MapWiseCount {
 public:
  explicit MapWiseCount(double voxel_size_m) : reach_m_(0.5 * voxel_size_m) {}

  void add_removed(const Eigen::Vector3d& point_map_m, bool truth_is_dynamic);
  /// Points without truth are of the map, too, but count nowhere.
  void add_to_map(const Eigen::Vector3d& point_map_m);
  void count_kept(bool truth_is_dynamic) { counts_.add(truth_is_dynamic, Label::kStatic); }

  Confusion counts() const;

 private:
  struct Removed {
    Eigen::Vector3d point;
    bool dynamic, retained;
  };
  BlockKey cell_of(const Eigen::Vector3d& point) const;

  double reach_m_;
  std::vector<Removed> removed_;
  tsl::robin_map<std::uint64_t, std::vector<std::uint32_t>, BlockKeyHash> near_;  ///< removed_, by cell
  Confusion counts_;
};

}  // namespace stillmap
