#pragma once

#include <geometry_msgs/PointStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/subscriber.h>
#include <stillmap/ExplainPoint.h>

#include <functional>
#include <string>

#include "ros/shared_mapper.hpp"

namespace stillmap {

/// ~explain_point, and the same for a point clicked in rviz: the answer in words on the console and as
/// markers on ~explanation.
class PlaceExplainer {
 public:
  /// `fixed_frame` says the map's frame.
  PlaceExplainer(ros::NodeHandle nh, ros::NodeHandle private_nh, SharedMapper& shared,
                 std::function<std::string()> fixed_frame);

 private:
  Explanation explain(const Eigen::Vector3d& point_map_m);
  bool on_service(ExplainPoint::Request& request, ExplainPoint::Response& response);
  void on_click(const geometry_msgs::PointStampedConstPtr& clicked);

  SharedMapper& shared_;
  std::function<std::string()> fixed_frame_;
  ros::Publisher markers_;
  ros::ServiceServer service_;
  ros::Subscriber clicks_;
};

}  // namespace stillmap
