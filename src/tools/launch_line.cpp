#include "tools/launch_line.hpp"

#include <filesystem>

#include "ros/odometry_presets.hpp"

namespace stillmap {
namespace {

struct SetText {
  const std::string &name, &value;
  bool has_changed = false;
  void operator()(const ParameterInfo& info, std::string& parameter) {
    if (name != info.name || parameter == value) return;
    parameter = value;
    has_changed = true;
  }
  template <class Number>
  void operator()(const ParameterInfo&, Number&) {}
};

/// What must be named beside the preset.
std::string arguments_beside(const std::string& preset, const NodeParameters& node, std::size_t& how_many) {
  NodeParameters base;
  apply_odometry_preset(preset, base);
  std::string text;
  how_many = 0;
  const auto name_if_other = [&](const char* name, const std::string& value, const std::string& of_preset) {
    if (value == of_preset) return;
    const bool needs_quotes = value.find(' ') != std::string::npos;
    text += std::string(" ") + name + ":=" + (needs_quotes ? "\"" + value + "\"" : value);
    ++how_many;
  };
  name_if_other("cloud_topic", node.cloud_topic, base.cloud_topic);
  name_if_other("odom_topic", node.odom_topic, base.odom_topic);
  name_if_other("cloud_frame", node.cloud_frame, base.cloud_frame);
  name_if_other("sensor_on_body", node.sensor_on_body, base.sensor_on_body);
  name_if_other("odometry_axes", node.odometry_axes, base.odometry_axes);
  return text;
}

std::string ending(const std::string& bag) {
  return " bag:=" + std::filesystem::absolute(bag).string() + " rviz:=true";
}

}  // namespace

bool set_node_parameter(NodeParameters& node, const std::string& name, const std::string& value) {
  SetText set{name, value};
  visit_node_parameters(node, set);
  return set.has_changed;
}

std::string to_text(const NodeParameters& node) {
  return node.cloud_topic + " (" + node.cloud_frame + ") with " + node.odom_topic + " (axes " +
         node.odometry_axes + "), sensor_on_body " + node.sensor_on_body;
}

std::string launch_line(const NodeParameters& node, const std::string& bag) {
  std::string preset = node.odometry_preset;
  std::size_t fewest = 0;
  std::string arguments = arguments_beside(preset, node, fewest);
  for (const OdometryPreset& other : odometry_presets()) {
    std::size_t how_many = 0;
    const std::string beside = arguments_beside(other.name, node, how_many);
    if (how_many < fewest) preset = other.name, arguments = beside, fewest = how_many;
  }
  return "roslaunch stillmap stillmap.launch preset:=" + preset + arguments + ending(bag);
}

std::string launch_line_with_tf(const BagContents& contents, const std::string& bag) {
  const std::string root = contents.tf_roots.empty() ? "ODOM_FRAME" : contents.tf_roots.front();
  return "roslaunch stillmap stillmap.launch cloud_topic:=" + contents.clouds.begin()->first +
         " cloud_frame:=sensor odom_topic:=tf2 fixed_frame:=" + root + ending(bag);
}

}  // namespace stillmap
