#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "ros/node_parameters.hpp"

namespace stillmap {

/// One LiDAR of the robot: the topic of its scans, and where it is.
struct LidarPlace {
  std::string topic;
  Eigen::Isometry3d T_body_sensor;
};

/// The LiDARs that cloud_topic and sensor_on_body name: topics with spaces between, places with semicolons.
/// Throws std::invalid_argument when there is no topic, one twice, or not a place for each.
std::vector<LidarPlace> lidar_places(const NodeParameters& parameters);

}  // namespace stillmap
