#pragma once

#include <ros/node_handle.h>

#include "ros/node_parameters.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {

struct NodeSettings {
  Parameters method;
  NodeParameters node;
};

/// Reads all private parameters. Throws std::runtime_error naming the first that is unknown, of another type
/// or out of range, and what to do.
NodeSettings load_settings(const ros::NodeHandle& private_nh);

}  // namespace stillmap
