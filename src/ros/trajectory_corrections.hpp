#pragma once

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "ros/node_parameters.hpp"
#include "ros/throttled_log.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {

/// Loop closures: a corrected path on a topic, or a jump of tf2's fixed_frame <- odom_frame, moves the map.
class TrajectoryCorrections {
 public:
  TrajectoryCorrections(ros::NodeHandle nh, const NodeParameters& parameters, ThrottledLog& log);

  /// Before a scan of this stamp is processed.
  void apply(Mapper& mapper, std::int64_t stamp_ns, const std::string& fixed_frame);

 private:
  void on_path(const nav_msgs::PathConstPtr& path);
  void apply_path(Mapper& mapper, const nav_msgs::Path& path, const std::string& fixed_frame);
  void apply_jump(Mapper& mapper, std::int64_t stamp_ns, const std::string& fixed_frame);
  template <class Correct>
  bool corrected(const std::string& source, const Correct& correct);

  const NodeParameters parameters_;
  const PairingOptions pairing_;  ///< of the first LiDAR, whose poses are the trajectory
  ThrottledLog& log_;
  std::mutex mutex_;
  nav_msgs::PathConstPtr newest_path_;  ///< not applied yet
  ros::Subscriber path_subscriber_;
  std::unique_ptr<tf2_ros::Buffer> tf_buffer_;
  std::unique_ptr<tf2_ros::TransformListener> tf_listener_;
  std::optional<Eigen::Isometry3d> T_fixed_odom_;  ///< that the map is placed by
};

}  // namespace stillmap
