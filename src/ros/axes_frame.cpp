#include "ros/axes_frame.hpp"

#include <geometry_msgs/TransformStamped.h>

#include "messages/pose_message.hpp"

namespace stillmap {

void AxesFrame::announce(const std::string& odometry_frame) {
  if (odometry_frame == announced_) return;
  announced_ = odometry_frame;
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time::now();
  transform.header.frame_id = odometry_frame;
  transform.child_frame_id = name_of(odometry_frame);
  const Eigen::Matrix3d R_odometry_map = R_ros_odometry_.transpose();
  transform.transform.rotation = to_message(Eigen::Quaterniond(R_odometry_map));
  broadcaster_.sendTransform(transform);
}

}  // namespace stillmap
