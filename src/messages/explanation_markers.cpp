#include "messages/explanation_markers.hpp"

#include <algorithm>

#include "messages/colors.hpp"

namespace stillmap {
namespace {

using visualization_msgs::Marker;

geometry_msgs::Point to_point(const Eigen::Vector3d& place) {
  geometry_msgs::Point point;
  point.x = place.x();
  point.y = place.y();
  point.z = place.z();
  return point;
}

Marker marker(const std::string& frame_id, int id, int type) {
  Marker marker;
  marker.header.frame_id = frame_id;
  marker.ns = "explanation";
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1;
  return marker;
}

Marker ball(const Explanation& explanation, const std::string& frame_id) {
  Marker ball = marker(frame_id, 0, Marker::SPHERE);
  ball.pose.position = to_point(explanation.place_map_m);
  ball.scale.x = ball.scale.y = ball.scale.z = 0.25;
  ball.color = explanation.in_map ? color_of(explanation.label) : color(1, 1, 1);
  return ball;
}

/// Lines of at most so many letters, or rviz draws one as wide as the world.
std::string wrapped(std::string text) {
  constexpr std::size_t kLetters = 60;
  std::size_t line_start = 0;
  for (std::size_t i = 0, last_space = 0; i < text.size(); ++i) {
    if (text[i] == ' ') last_space = i;
    if (i - line_start < kLetters || last_space <= line_start) continue;
    text[last_space] = '\n';
    line_start = last_space + 1;
  }
  return text;
}

Marker words(const Explanation& explanation, const std::string& frame_id) {
  Marker words = marker(frame_id, 1, Marker::TEXT_VIEW_FACING);
  words.scale.z = 0.6;
  words.color = color(1, 1, 1);
  words.text = wrapped(in_words(explanation));
  const auto lines = 1 + std::count(words.text.begin(), words.text.end(), '\n');
  const Eigen::Vector3d above(0, 0, 1 + 0.5 * words.scale.z * static_cast<double>(lines));
  words.pose.position = to_point(explanation.place_map_m + above);
  return words;
}

std_msgs::ColorRGBA color_of(Evidence kind) {
  if (kind == Evidence::kConflict) return color_of(Label::kDynamic);
  return kind == Evidence::kSupport ? color(0.2F, 0.85F, 0.3F) : color(0.5F, 0.5F, 0.5F);
}

/// From the origin through the place to where the beam ended.
Marker rays(const Explanation& explanation, const std::string& frame_id) {
  Marker rays = marker(frame_id, 2, Marker::LINE_LIST);
  rays.scale.x = 0.02;
  for (const PlaceEvidence& evidence : explanation.evidence) {
    if (evidence.kind == Evidence::kUnknown || !(evidence.range_m > 0)) continue;
    const double share = 1 + evidence.difference_m() / evidence.range_m;
    const Eigen::Vector3d way = explanation.place_map_m - evidence.origin_map_m;
    rays.points.push_back(to_point(evidence.origin_map_m));
    rays.points.push_back(to_point(evidence.origin_map_m + share * way));
    rays.colors.insert(rays.colors.end(), 2, color_of(evidence.kind));
  }
  if (rays.points.empty()) rays.action = Marker::DELETE;
  return rays;
}

}  // namespace

visualization_msgs::MarkerArray to_markers(const Explanation& explanation, const std::string& frame_id) {
  visualization_msgs::MarkerArray markers;
  markers.markers = {ball(explanation, frame_id), words(explanation, frame_id), rays(explanation, frame_id)};
  return markers;
}

}  // namespace stillmap
