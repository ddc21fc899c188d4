#pragma once

#include <string>

#include "ros/node_parameters.hpp"
#include "tools/bag_examination.hpp"

namespace stillmap {

/// Sets a text parameter by its name; false when it had that value.
bool set_node_parameter(NodeParameters& node, const std::string& name, const std::string& value);

/// "/cloud_registered (world) with /Odometry, ..."
std::string to_text(const NodeParameters& node);

/// The roslaunch command: the preset that leaves least to name, and what differs from it.
std::string launch_line(const NodeParameters& node, const std::string& bag);
std::string launch_line_with_tf(const BagContents& contents, const std::string& bag);

}  // namespace stillmap
