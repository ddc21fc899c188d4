#include "ros/trajectory_corrections.hpp"

#include <geometry_msgs/TransformStamped.h>
#include <ros/console.h>

#include <chrono>
#include <stdexcept>

#include "messages/frame_id.hpp"
#include "ros/axes_frame.hpp"

namespace stillmap {
namespace {

template <class Position, class Quaternion>
Eigen::Isometry3d to_isometry(const Position& p, const Quaternion& q) {
  return checked_pose({p.x, p.y, p.z}, {q.w, q.x, q.y, q.z});
}

}  // namespace

TrajectoryCorrections::TrajectoryCorrections(ros::NodeHandle nh, const NodeParameters& parameters,
                                             ThrottledLog& log)
    : parameters_(parameters), pairing_(check_node_parameters(parameters)), log_(log) {
  if (!parameters.corrected_path_topic.empty())
    path_subscriber_ =
        nh.subscribe(parameters.corrected_path_topic, 1, &TrajectoryCorrections::on_path, this);
  if (parameters.odom_frame.empty()) return;
  tf_buffer_ = std::make_unique<tf2_ros::Buffer>();
  tf_listener_ = std::make_unique<tf2_ros::TransformListener>(*tf_buffer_);
}

void TrajectoryCorrections::on_path(const nav_msgs::PathConstPtr& path) {
  const std::lock_guard lock(mutex_);
  newest_path_ = path;
}

void TrajectoryCorrections::apply(Mapper& mapper, std::int64_t stamp_ns, const std::string& fixed_frame) {
  nav_msgs::PathConstPtr path;
  {
    const std::lock_guard lock(mutex_);
    path.swap(newest_path_);
  }
  if (path) apply_path(mapper, *path, fixed_frame);
  if (tf_buffer_) apply_jump(mapper, stamp_ns, fixed_frame);
}

/// True when the map could follow; refusals leave it as it was.
template <class Correct>
bool TrajectoryCorrections::corrected(const std::string& source, const Correct& correct) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const TrajectoryCorrection done = correct();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (done.applied)
      ROS_INFO_STREAM(source << ": the map follows the corrected trajectory, " << done.submaps
                             << " submaps, the farthest by " << done.largest_m << " m; it took "
                             << took.count() << " s");
    return done.applied;
  } catch (const std::invalid_argument& error) {
    log_.warn("correction", source + ": not used, the map stays as it is: " + error.what());
    return false;
  }
}

void TrajectoryCorrections::apply_path(Mapper& mapper, const nav_msgs::Path& path,
                                       const std::string& fixed_frame) {
  if (mapper.scan_count() == 0) return;
  const std::string frame = without_leading_slash(path.header.frame_id);
  const bool ros_axes = pairing_.R_ros_odometry.isIdentity();
  if ((ros_axes ? frame : AxesFrame::name_of(frame)) != fixed_frame) {
    log_.warn("corrected path's frame", parameters_.corrected_path_topic +
                                            ": not used, the map stays as it is: the path is in frame '" +
                                            path.header.frame_id + "' and the map in '" + fixed_frame + "'");
    return;
  }
  corrected(parameters_.corrected_path_topic, [&] {
    const Eigen::Isometry3d R(pairing_.R_ros_odometry);
    std::vector<StampedPose> poses;
    for (const geometry_msgs::PoseStamped& pose : path.poses)
      poses.push_back({static_cast<std::int64_t>(pose.header.stamp.toNSec()),
                       R * to_isometry(pose.pose.position, pose.pose.orientation) * R.inverse() *
                           pairing_.T_body_sensor});
    return mapper.correct_trajectory(poses);
  });
}

void TrajectoryCorrections::apply_jump(Mapper& mapper, std::int64_t stamp_ns,
                                       const std::string& fixed_frame) {
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(stamp_ns));
  Eigen::Isometry3d T_fixed_odom;
  try {
    const auto transform =
        tf_buffer_->lookupTransform(fixed_frame, without_leading_slash(parameters_.odom_frame), stamp);
    T_fixed_odom = to_isometry(transform.transform.translation, transform.transform.rotation);
  } catch (const std::exception& error) {
    log_.warn("odom_frame", parameters_.odom_frame + ": jumps cannot be seen: " + error.what());
    return;
  }
  const bool first = !T_fixed_odom_ || mapper.scan_count() == 0;
  const auto jump = [&] { return mapper.correct_newest_pose(T_fixed_odom * T_fixed_odom_->inverse()); };
  if (first || corrected(parameters_.odom_frame, jump)) T_fixed_odom_ = T_fixed_odom;
}

}  // namespace stillmap
