#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace stillmap {

/// Where the sensor was at a time.
struct StampedPose {
  std::int64_t stamp_ns = 0;
  Eigen::Isometry3d T_map_sensor = Eigen::Isometry3d::Identity();
};

/// What a corrected trajectory did to the map.
struct TrajectoryCorrection {
  bool applied = false;  ///< false: no submap moved as far as a voxel
  double largest_m = 0;  ///< way of the submap that moves farthest
  std::size_t submaps = 0;
};

}  // namespace stillmap
