#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace stillmap {

/// Region-wise ground plane fitting (ERASOR, section III-E).
struct GroundPlaneSettings {
  int iterations = 3;
  int lowest_points = 20;          ///< whose mean height starts the fit
  double seed_height_m = 0.5;      ///< above that mean: the first set to fit
  double plane_distance_m = 0.15;  ///< above the plane: still ground
};

/// For each of `points` 1 where it belongs to the ground of its region; z is up. All are ground where there
/// are too few for a plane.
std::vector<std::uint8_t> find_ground(const std::vector<Eigen::Vector3d>& points,
                                      const GroundPlaneSettings& settings);

}  // namespace stillmap
