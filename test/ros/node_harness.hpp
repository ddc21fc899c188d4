#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <rosgraph_msgs/Log.h>
#include <sensor_msgs/PointCloud2.h>
#include <stillmap/Status.h>

#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace stillmap {

/// What the node said of one scan.
struct Answer {
  sensor_msgs::PointCloud2ConstPtr static_points, dynamic_points, uncertain_points, labelled_points;
  sensor_msgs::PointCloud2ConstPtr resolved;  ///< comes later
  StatusConstPtr status;
  bool is_complete() const {
    return static_points && dynamic_points && uncertain_points && labelled_points && status;
  }
};

/// Talks to a node /stillmap as an odometry and a user would. All waiting is in wall time: under a
/// recording's clock, time may stand still.
class NodeHarness {
 public:
  NodeHarness();

  static bool wait_until(const std::function<bool()>& is_so, double patience_s = 30);
  /// `logging`: how many processes write to the log, this one and the node's unless the node is in this one.
  bool wait_for_connections(std::size_t logging = 2);
  void publish(const sensor_msgs::PointCloud2& cloud) { cloud_publisher_.publish(cloud); }
  void publish(const nav_msgs::Odometry& odometry) { odometry_publisher_.publish(odometry); }

  /// Waits for all five messages about the scan at its own time; nullptr when they do not come.
  const Answer* answer(const ros::Time& stamp, double patience_s = 30);
  std::size_t answers() const { return answers_.size(); }
  /// Waits for the scan's resolved cloud.
  sensor_msgs::PointCloud2ConstPtr resolved(const ros::Time& stamp, double patience_s = 30);
  /// Waits for a line of the node's log with these words.
  bool said(const std::string& words, double patience_s = 15);
  void forget_what_was_said() { log_.clear(); }

 private:
  ros::NodeHandle nh_;
  ros::Publisher cloud_publisher_, odometry_publisher_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Subscriber log_subscriber_;
  std::map<ros::Time, Answer> answers_;
  std::vector<std::string> log_;
};

/// What a sensor sees that stands in an empty room.
std::vector<Eigen::Vector3d> room_points();
/// Its scan k, ten a second.
ros::Time room_stamp(int k);
sensor_msgs::PointCloud2Ptr room_cloud(int k);
nav_msgs::Odometry room_odometry(int k);

}  // namespace stillmap
