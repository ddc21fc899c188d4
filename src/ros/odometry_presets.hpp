#pragma once

#include <string>
#include <vector>

#include "ros/node_parameters.hpp"

namespace stillmap {

/// A file of config/presets, compiled in: the node parameters that fit an odometry package.
struct OdometryPreset {
  std::string name;
  std::string yaml;
};

/// In the order of their names.
const std::vector<OdometryPreset>& odometry_presets();

/// Sets what the preset says and its name. Throws std::invalid_argument listing the names when there is none
/// such.
void apply_odometry_preset(const std::string& name, NodeParameters& parameters);

}  // namespace stillmap
