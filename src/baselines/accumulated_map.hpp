#pragma once

#include <tsl/robin_map.h>

#include <cstdint>
#include <vector>

#include "io/sequence.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// All returns of a sequence in the map frame, down-sampled to one point for each voxel: their mean.
class AccumulatedMap {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  explicit AccumulatedMap(double voxel_size_m) : voxels_(voxel_size_m) {}

  void add(const Frame& frame);

  const std::vector<Eigen::Vector3d>& points() const { return points_; }  ///< map frame, metres
  std::size_t scan_count() const { return point_of_row_.size(); }
  /// For each row of the k-th scan its point, or kNone where the row holds no return.
  const std::vector<std::uint32_t>& point_of_row(std::size_t k) const { return point_of_row_.at(k); }

 private:
  VoxelMap voxels_;
  tsl::robin_map<std::uint64_t, std::uint32_t, BlockKeyHash> index_;  ///< by block index and place
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::uint32_t> returns_;  ///< in each point's mean
  std::vector<std::vector<std::uint32_t>> point_of_row_;
};

}  // namespace stillmap
