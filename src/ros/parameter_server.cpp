#include "ros/parameter_server.hpp"

#include <XmlRpcValue.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "io/nearest_name.hpp"
#include "io/parameters_yaml.hpp"
#include "ros/odometry_presets.hpp"

namespace stillmap {
namespace {

using XmlRpc::XmlRpcValue;

// In the same namespace, but for others: diagnostic_updater and the nodelet library.
const std::vector<std::string> kForeign = {"diagnostic_period", "num_worker_threads"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string to_yaml_text(XmlRpcValue value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return std::to_string(static_cast<int>(value));
    case XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    case XmlRpcValue::TypeDouble: {
      char text[32];
      std::snprintf(text, sizeof(text), "%.17g", static_cast<double>(value));
      return text;
    }
    case XmlRpcValue::TypeArray: {
      std::string text;
      for (int i = 0; i < value.size(); ++i) text += (i ? ", " : "") + to_yaml_text(value[i]);
      return "[" + text + "]";
    }
    default:
      return "(binary)";
  }
}

struct SetFromServer {
  std::string name;
  XmlRpcValue given;
  bool found = false;

  void operator()(const ParameterInfo& info, std::string& value) {
    if (name != info.name) return;
    found = true;
    value = to_yaml_text(given);
  }
  template <class Number>
  void operator()(const ParameterInfo& info, Number& value) {
    if (name != info.name) return;
    found = true;
    if (given.getType() == XmlRpcValue::TypeInt)
      value = static_cast<int>(given);
    else if (given.getType() == XmlRpcValue::TypeDouble && std::is_floating_point_v<Number>)
      value = static_cast<double>(given);
    else
      throw std::runtime_error(name + ": '" + to_yaml_text(given) + "' is not a " +
                               (std::is_integral_v<Number> ? "whole number" : "number"));
  }
};

std::vector<std::string> known_names() {
  std::vector<std::string> names = parameter_names();
  NodeParameters defaults;
  visit_node_parameters(defaults, [&](const ParameterInfo& info, auto&) { names.push_back(info.name); });
  names.push_back("preset");
  return names;
}

[[noreturn]] void refuse_unknown(const std::string& name) {
  const std::string nearest = nearest_name(name, known_names());
  throw std::runtime_error(
      name + ": unknown parameter; " +
      (nearest.empty() ? "remove it (config/default.yaml lists all)" : "did you mean " + nearest + "?"));
}

void set_from_server(NodeSettings& settings, const std::string& name, const XmlRpcValue& given) {
  if (name == "preset" || contains(kForeign, name)) return;
  if (given.getType() == XmlRpcValue::TypeStruct) return;  // a namespace below, not a parameter
  SetFromServer set{name, given};
  visit_node_parameters(settings.node, set);
  if (set.found) return;
  if (!contains(parameter_names(), name)) refuse_unknown(name);
  set_parameter(settings.method, name, to_yaml_text(given));
}

/// As NodeHandle::param(), which is const in newer roscpp only.
std::string text_param(const ros::NodeHandle& nh, const std::string& name, std::string value) {
  nh.getParam(name, value);
  return value;
}

}  // namespace

NodeSettings load_settings(const ros::NodeHandle& private_nh) {
  const std::string& where = private_nh.getNamespace();
  try {
    NodeSettings settings;
    settings.method = preset(text_param(private_nh, "preset", "default"));
    apply_odometry_preset(text_param(private_nh, "odometry_preset", settings.node.odometry_preset),
                          settings.node);
    XmlRpcValue all;
    if (private_nh.getParam(where, all) && all.getType() == XmlRpcValue::TypeStruct)
      for (auto& [name, value] : all) set_from_server(settings, name, value);
    check_parameters(settings.method, "the method's parameters");
    check_node_parameters(settings.node);
    return settings;
  } catch (const std::exception& error) {
    throw std::runtime_error("parameters of " + where + ": " + error.what());
  }
}

}  // namespace stillmap
