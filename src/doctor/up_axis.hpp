#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "doctor/finding.hpp"
#include "messages/pairing_options.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// The widest plane near the sensor.
struct WidestPlane {
  char lies_across = 'z';  ///< x or y only if it is clearly wider than any level plane
  std::size_t m2 = 0, level_m2 = 0;
};
/// Of points relative to the sensor, in the axes of the map.
WidestPlane widest_plane(const std::vector<Eigen::Vector3f>& upright);

/// Turned axes: the widest plane near the sensor must be level (ground or ceiling), not upright.
std::optional<Finding> check_up_axis(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                                     const PairingOptions& said);

}  // namespace stillmap
