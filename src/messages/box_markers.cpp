#include "messages/box_markers.hpp"

#include <algorithm>

#include "messages/colors.hpp"

namespace stillmap {

visualization_msgs::MarkerArray to_markers(const std::vector<MovingBox>& boxes,
                                           const std_msgs::Header& header, double lifetime_s) {
  constexpr double kThinnest_m = 0.05;  // rviz draws nothing that has no extent
  visualization_msgs::MarkerArray markers;
  for (const MovingBox& box : boxes) {
    visualization_msgs::Marker marker;
    marker.header = header;
    marker.ns = "moving";
    marker.id = static_cast<int>(markers.markers.size());
    marker.type = visualization_msgs::Marker::CUBE;
    const Eigen::Vector3d middle = box.T_map_box.translation(), size_m = box.size_m.cwiseMax(kThinnest_m);
    const Eigen::Quaterniond turn(box.T_map_box.linear());
    marker.pose.position.x = middle.x();
    marker.pose.position.y = middle.y();
    marker.pose.position.z = middle.z();
    marker.pose.orientation.z = turn.z();
    marker.pose.orientation.w = turn.w();
    marker.scale.x = size_m.x();
    marker.scale.y = size_m.y();
    marker.scale.z = size_m.z();
    marker.color = color_of(Label::kDynamic);
    marker.color.a = 0.35F;
    marker.lifetime = ros::Duration(lifetime_s);
    markers.markers.push_back(marker);
  }
  return markers;
}

}  // namespace stillmap
