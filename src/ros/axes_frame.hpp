#pragma once

#include <tf2_ros/static_transform_broadcaster.h>

#include <Eigen/Core>
#include <string>

namespace stillmap {

/// The map's frame where the odometry's own does not have z up: its name, and the static transform to it.
class AxesFrame {
 public:
  explicit AxesFrame(const Eigen::Matrix3d& R_ros_odometry) : R_ros_odometry_(R_ros_odometry) {}
  static std::string name_of(const std::string& odometry_frame) { return odometry_frame + "_z_up"; }
  /// Sends the transform when the odometry's frame is a new one.
  void announce(const std::string& odometry_frame);

 private:
  Eigen::Matrix3d R_ros_odometry_;
  std::string announced_;
  tf2_ros::StaticTransformBroadcaster broadcaster_;
};

}  // namespace stillmap
