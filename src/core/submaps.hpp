#pragma once

#include <vector>

#include "scan_view.hpp"
#include "stillmap/voxel_map.hpp"
#include "trajectory.hpp"
#include "voxel_reader.hpp"

namespace stillmap {

/// A voxel with its place, apart from any map.
struct PlacedVoxel {
  VoxelKey key;
  Voxel voxel;
};

/// A piece of the way and what was first seen on it. Its evidence is that of the scans on it and on the next
/// piece; it moves as one when the trajectory is corrected.
struct Submap {
  std::int64_t stamp_ns = 0;    ///< of its first scan, whose correction is the submap's
  bool anchored = true;         ///< false: of an imported map, which stays in its place
  bool closed = false;          ///< its voxels are as its evidence left them; else they live in the map
  std::uint32_t scan = 0;       ///< as of which they are
  std::vector<ScanView> views;  ///< some of its scans, which judge what was seen before
  std::vector<PlacedVoxel> voxels;
};

/// Keeps what a corrected trajectory needs to move the map: what each scan adds is its new voxels' keys, and
/// once in a while a view of it.
class Submaps {
 public:
  explicit Submaps(double length_m) : length_m_(length_m) {}
  bool enabled() const { return length_m_ > 0; }

  /// After each scan; `born` are the keys of its new voxels. The first LiDAR makes the trajectory.
  void add(const StampedPose& pose, bool of_first_sensor, const ScanView& view,
           const std::vector<VoxelKey>& born, VoxelReader map);
  /// Voxels that no scan of this run saw first; they stay in place.
  void add_unanchored(std::vector<PlacedVoxel> voxels, std::uint32_t scan);

  std::vector<Submap>& all() { return submaps_; }
  const std::vector<Submap>& all() const { return submaps_; }
  const Trajectory& trajectory() const { return trajectory_; }
  Trajectory& trajectory() { return trajectory_; }
  std::int64_t corrected_until_ns = 0;  ///< the newest scan at the last correction

  /// Gives the voxels of a submap that is not closed what the map says of them now.
  static void refresh(Submap& submap, VoxelReader& map);

 private:
  static constexpr double kViewsInSubmap = 5;
  void go_to(const StampedPose& pose);
  void begin(const StampedPose& pose, VoxelReader& map);

  double length_m_;
  double way_m_ = 0, view_way_m_ = 0;  ///< in the present submap, and where its last view was taken
  Trajectory trajectory_;
  std::vector<Submap> submaps_;
};

}  // namespace stillmap
