#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <string>

namespace stillmap {

/// The frame that the numbers x, y, z of a cloud are in, whatever its header says.
enum class CloudFrame {
  kWorld,  ///< registered: the odometry's fixed frame
  kBody,   ///< the frame whose pose the odometry reports
  kSensor  ///< as measured by the sensor (deskewed or not)
};

struct PairingOptions {
  CloudFrame cloud_frame = CloudFrame::kWorld;
  Eigen::Isometry3d T_body_sensor = Eigen::Isometry3d::Identity();
  /// Takes the axes of the odometry's frames to ROS's: x ahead, y left, z up. The map has ROS's axes.
  Eigen::Matrix3d R_ros_odometry = Eigen::Matrix3d::Identity();
  double max_gap_s = 0.5;       ///< longest time between two odometry messages to interpolate over
  std::size_t queue_size = 10;  ///< clouds that may wait for their pose
  std::size_t max_cloud_bytes = std::numeric_limits<std::size_t>::max();  ///< larger ones are dropped
};

/// "world", "body" or "sensor"; throws std::invalid_argument.
CloudFrame parse_cloud_frame(const std::string& text);

/// "ros", or "loam": x left, y up, z ahead; throws std::invalid_argument.
Eigen::Matrix3d parse_odometry_axes(const std::string& text);

/// The sensor's place on the body, "x y z roll_deg pitch_deg yaw_deg" or "x y z qx qy qz qw" in metres;
/// commas and brackets are taken as spaces. Throws std::invalid_argument.
Eigen::Isometry3d parse_sensor_on_body(const std::string& text);

/// Throws std::invalid_argument when a number is not finite or the quaternion is not of length one.
Eigen::Isometry3d checked_pose(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation);

}  // namespace stillmap
