#include "ros/odometry_presets.hpp"

#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <type_traits>

namespace stillmap {
namespace {

const OdometryPreset& find_preset(const std::string& name) {
  std::string names;
  for (const OdometryPreset& preset : odometry_presets()) {
    if (preset.name == name) return preset;
    names += (names.empty() ? "" : "|") + preset.name;
  }
  throw std::invalid_argument("odometry_preset: '" + name + "' is not one of " + names);
}

}  // namespace

void apply_odometry_preset(const std::string& name, NodeParameters& parameters) {
  const YAML::Node given = YAML::Load(find_preset(name).yaml);
  visit_node_parameters(parameters, [&](const ParameterInfo& info, auto& value) {
    if (const YAML::Node node = given[info.name]) value = node.as<std::decay_t<decltype(value)>>();
  });
  parameters.odometry_preset = name;
}

}  // namespace stillmap
