#include "ros/node_harness.hpp"

#include <ros/callback_queue.h>
#include <ros/init.h>

#include <cmath>

#include "messages/make_cloud.hpp"

namespace stillmap {
namespace {

constexpr std::uint64_t kFirstStamp_ns = 1'600'000'000'000'000'000, kTenth_ns = 100'000'000;
constexpr double kDegree = 3.14159265358979323846 / 180;

// To the nearest of walls at 5 m, the floor at -1 m and the ceiling at 2 m.
double range_in_room(const Eigen::Vector3d& direction) {
  const double to_wall = 5.0 / std::max(std::abs(direction.x()), std::abs(direction.y()));
  const double to_level = direction.z() == 0 ? to_wall : (direction.z() < 0 ? -1.0 : 2.0) / direction.z();
  return std::min(to_wall, to_level);
}

}  // namespace

NodeHarness::NodeHarness()
    : cloud_publisher_(nh_.advertise<sensor_msgs::PointCloud2>("/cloud_registered", 100)),
      odometry_publisher_(nh_.advertise<nav_msgs::Odometry>("/Odometry", 100)) {
  using Cloud = sensor_msgs::PointCloud2ConstPtr;
  const auto collect = [this](const std::string& topic, Cloud Answer::*slot) {
    const boost::function<void(const Cloud&)> keep = [this, slot](const Cloud& cloud) {
      answers_[cloud->header.stamp].*slot = cloud;
    };
    subscribers_.push_back(nh_.subscribe<sensor_msgs::PointCloud2>("/stillmap/" + topic, 100, keep));
  };
  collect("static_points", &Answer::static_points);
  collect("dynamic_points", &Answer::dynamic_points);
  collect("uncertain_points", &Answer::uncertain_points);
  collect("labelled_points", &Answer::labelled_points);
  collect("resolved", &Answer::resolved);
  const boost::function<void(const StatusConstPtr&)> keep_status = [this](const StatusConstPtr& status) {
    answers_[status->header.stamp].status = status;
  };
  subscribers_.push_back(nh_.subscribe<Status>("/stillmap/status", 100, keep_status));
  const boost::function<void(const rosgraph_msgs::LogConstPtr&)> keep_log =
      [this](const rosgraph_msgs::LogConstPtr& line) { log_.push_back(line->msg); };
  log_subscriber_ = nh_.subscribe<rosgraph_msgs::Log>("/rosout", 1000, keep_log);
}

bool NodeHarness::wait_until(const std::function<bool()>& is_so, double patience_s) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(patience_s);
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    if (is_so()) return true;
    if (ros::WallTime::now() > deadline) return false;
  }
  return false;
}

bool NodeHarness::wait_for_connections(std::size_t logging) {
  return wait_until([&] {
    if (cloud_publisher_.getNumSubscribers() == 0) return false;
    if (log_subscriber_.getNumPublishers() < logging) return false;
    for (const ros::Subscriber& subscriber : subscribers_)
      if (subscriber.getNumPublishers() == 0) return false;
    return true;
  });
}

const Answer* NodeHarness::answer(const ros::Time& stamp, double patience_s) {
  const bool has_come = wait_until([&] { return answers_[stamp].is_complete(); }, patience_s);
  return has_come ? &answers_[stamp] : nullptr;
}

sensor_msgs::PointCloud2ConstPtr NodeHarness::resolved(const ros::Time& stamp, double patience_s) {
  wait_until([&] { return answers_[stamp].resolved != nullptr; }, patience_s);
  return answers_[stamp].resolved;
}

bool NodeHarness::said(const std::string& words, double patience_s) {
  return wait_until(
      [&] {
        for (const std::string& line : log_)
          if (line.find(words) != std::string::npos) return true;
        return false;
      },
      patience_s);
}

ros::Time room_stamp(int k) {
  ros::Time stamp;
  return stamp.fromNSec(kFirstStamp_ns + k * kTenth_ns);
}

std::vector<Eigen::Vector3d> room_points() {
  std::vector<Eigen::Vector3d> points;
  for (int column = 0; column < 360; ++column)
    for (int ring = -8; ring < 8; ++ring) {
      const double azimuth = column * kDegree, elevation = 2 * ring * kDegree;
      const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth),
                                      std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      points.push_back(direction * range_in_room(direction));
    }
  return points;
}

sensor_msgs::PointCloud2Ptr room_cloud(int k) {
  return make_cloud(room_points(), room_stamp(k).toNSec());
}

nav_msgs::Odometry room_odometry(int k) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = room_stamp(k);
  odometry.header.frame_id = "/camera_init";
  odometry.child_frame_id = "body";
  odometry.pose.pose.orientation.w = 1;
  return odometry;
}

}  // namespace stillmap
