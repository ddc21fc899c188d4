#include "ros/place_explainer.hpp"

#include <ros/console.h>

#include "messages/explanation_markers.hpp"
#include "messages/frame_id.hpp"

namespace stillmap {
namespace {

void fill(ExplainPoint::Response& response, const Explanation& explanation) {
  response.in_map = explanation.in_map;
  response.label = static_cast<std::uint8_t>(explanation.label);
  response.p_static = explanation.p_static;
  const PlaceEvidence* last = last_evidence(explanation);
  if (last == nullptr) return;
  response.evidence = to_string(last->kind);
  response.stamp.fromNSec(static_cast<std::uint64_t>(last->stamp_ns));
  response.level_deg = static_cast<float>(last->level_deg);
  response.difference_m = last->difference_m();
}

}  // namespace

PlaceExplainer::PlaceExplainer(ros::NodeHandle nh, ros::NodeHandle private_nh, SharedMapper& shared,
                               std::function<std::string()> fixed_frame)
    : shared_(shared), fixed_frame_(std::move(fixed_frame)) {
  const bool latch = true;
  markers_ = private_nh.advertise<visualization_msgs::MarkerArray>("explanation", 1, latch);
  service_ = private_nh.advertiseService("explain_point", &PlaceExplainer::on_service, this);
  nh.setCallbackQueue(private_nh.getCallbackQueue());
  clicks_ = nh.subscribe("clicked_point", 1, &PlaceExplainer::on_click, this);
}

Explanation PlaceExplainer::explain(const Eigen::Vector3d& point_map_m) {
  std::unique_lock lock(shared_.mutex);
  const Explanation explanation = shared_.mapper.explain(point_map_m);
  lock.unlock();
  ROS_INFO_STREAM("explain_point: " << in_words(explanation));
  markers_.publish(to_markers(explanation, fixed_frame_()));
  return explanation;
}

bool PlaceExplainer::on_service(ExplainPoint::Request& request, ExplainPoint::Response& response) {
  const Eigen::Vector3d point_map_m(request.point.x, request.point.y, request.point.z);
  response.success = point_map_m.allFinite();
  if (response.success) {
    const Explanation explanation = explain(point_map_m);
    response.message = in_words(explanation);
    fill(response, explanation);
  } else {
    response.message = "a coordinate of the point is not finite";
  }
  return true;
}

void PlaceExplainer::on_click(const geometry_msgs::PointStampedConstPtr& clicked) {
  const std::string frame = without_leading_slash(clicked->header.frame_id), map_frame = fixed_frame_();
  const Eigen::Vector3d point_map_m(clicked->point.x, clicked->point.y, clicked->point.z);
  if (frame != map_frame)
    ROS_WARN_STREAM(clicks_.getTopic() << ": the point is in frame '" << frame << "' and the map in '"
                                       << map_frame << "'; set rviz's Fixed Frame to that");
  else if (!point_map_m.allFinite())
    ROS_WARN_STREAM(clicks_.getTopic() << ": a coordinate of the point is not finite");
  else
    explain(point_map_m);
}

}  // namespace stillmap
