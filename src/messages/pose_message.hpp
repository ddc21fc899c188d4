#pragma once

#include <geometry_msgs/Pose.h>

#include <Eigen/Geometry>

namespace stillmap {

inline geometry_msgs::Quaternion to_message(const Eigen::Quaterniond& rotation) {
  geometry_msgs::Quaternion message;
  message.x = rotation.x();
  message.y = rotation.y();
  message.z = rotation.z();
  message.w = rotation.w();
  return message;
}

inline geometry_msgs::Pose to_message(const Eigen::Isometry3d& T) {
  geometry_msgs::Pose message;
  message.position.x = T.translation().x();
  message.position.y = T.translation().y();
  message.position.z = T.translation().z();
  message.orientation = to_message(Eigen::Quaterniond(T.linear()));
  return message;
}

}  // namespace stillmap
