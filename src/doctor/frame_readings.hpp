#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "doctor/finding.hpp"
#include "messages/pairing_options.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// A scan as the message had it, with the odometry's own pose.
struct AsSent {
  std::vector<Eigen::Vector3f> points;
  Eigen::Isometry3d T_odom_body;
};
/// Takes back what pairing did to the points and the pose.
AsSent as_sent(const Scan& scan, const Eigen::Isometry3d& T_map_sensor, const PairingOptions& said);

/// How far the body went, and how far it turned.
struct Motion {
  double way_m, turn_rad;
};
Motion motion_between(const AsSent& a, const AsSent& b);

/// Upright things seen in two scans must fall on each other. Names the reading of cloud_frame and
/// odometry_axes in which they do when the given one does not; needs motion between the scans.
std::optional<Finding> check_frames(const AsSent& a, const AsSent& b, const PairingOptions& said);

/// An odometry that stands while what the sensor sees has moved.
std::optional<Finding> check_still(const AsSent& a, const AsSent& b, const PairingOptions& said);

}  // namespace stillmap
