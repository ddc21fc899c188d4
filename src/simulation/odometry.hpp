#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace stillmap::simulation {

struct OdometryNoise {
  std::uint64_t seed = 1;
  double noise_m = 0;    ///< sigma along each axis, independent in each pose
  double noise_deg = 0;  ///< sigma about each axis, independent in each pose
  double drift_percent = 0;
};

/// What an odometry would say of true poses: each step a little wrong in the same slowly changing direction,
/// and each pose shaken. The first pose has noise but no drift.
std::vector<Eigen::Isometry3d> odometry_poses(const std::vector<Eigen::Isometry3d>& T_map_sensor_true,
                                              const OdometryNoise& noise);

}  // namespace stillmap::simulation
