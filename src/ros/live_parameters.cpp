#include "ros/live_parameters.hpp"

#include <dynamic_reconfigure/ConfigDescription.h>
#include <ros/console.h>

#include <algorithm>
#include <set>
#include <type_traits>

namespace stillmap {
namespace {

// What may change without spoiling the map: it holds evidence, not decisions.
const std::set<std::string> kLive = {"p_static_min", "p_dynamic_max", "map_period_s"};

/// Calls act(info, value) for each live parameter of both lists.
template <class Settings, class Act>
void for_each_live(Settings& settings, const Act& act) {
  const auto visit = [&](const ParameterInfo& info, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
      if (kLive.count(info.name)) act(info, value);
  };
  visit_parameters(settings.method, visit);
  visit_node_parameters(settings.node, visit);
}

}  // namespace

LiveParameters::LiveParameters(ros::NodeHandle private_nh, const NodeSettings& settings)
    : private_nh_(private_nh) {
  for_each_live(settings, [&](const ParameterInfo& info, double value) {
    live_.push_back({info.name, info.help, info.min, info.max, value});
  });
  const bool latch = true;
  descriptions_ =
      private_nh.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, latch);
  updates_ = private_nh.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, latch);
  describe();
  updates_.publish(config(Which::kValue));
  set_parameters_ = private_nh.advertiseService("set_parameters", &LiveParameters::on_set, this);
}

dynamic_reconfigure::Config LiveParameters::config(Which which) const {
  dynamic_reconfigure::Config config;
  for (const Live& live : live_) {
    dynamic_reconfigure::DoubleParameter parameter;
    parameter.name = live.name;
    parameter.value = which == Which::kMin ? live.min : which == Which::kMax ? live.max : live.value;
    config.doubles.push_back(parameter);
  }
  dynamic_reconfigure::GroupState group;
  group.name = "Default";
  group.state = true;
  config.groups.push_back(group);
  return config;
}

void LiveParameters::describe() {
  dynamic_reconfigure::Group group;
  group.name = "Default";
  for (const Live& live : live_) {
    dynamic_reconfigure::ParamDescription parameter;
    parameter.name = live.name;
    parameter.type = "double";
    parameter.description = live.help;
    group.parameters.push_back(parameter);
  }
  dynamic_reconfigure::ConfigDescription description;
  description.groups.push_back(group);
  description.min = config(Which::kMin);
  description.max = config(Which::kMax);
  description.dflt = config(Which::kValue);
  descriptions_.publish(description);
}

bool LiveParameters::on_set(dynamic_reconfigure::Reconfigure::Request& request,
                            dynamic_reconfigure::Reconfigure::Response& response) {
  const std::lock_guard lock(mutex_);
  for (const dynamic_reconfigure::DoubleParameter& asked : request.config.doubles)
    set(asked.name, asked.value);
  response.config = config(Which::kValue);
  updates_.publish(response.config);
  return true;
}

void LiveParameters::set(const std::string& name, double value) {
  const auto live = std::find_if(live_.begin(), live_.end(), [&](const Live& l) { return l.name == name; });
  if (live == live_.end()) {
    ROS_WARN_STREAM("set_parameters: " << name
                                       << " cannot change while the node runs; set it before the start");
    return;
  }
  if (!(value >= live->min && value <= live->max)) {
    ROS_WARN_STREAM("set_parameters: " << name << ": " << value << " is not in [" << live->min << ", "
                                       << live->max << "]; it stays " << live->value);
    return;
  }
  if (value == live->value) return;
  live->value = value;
  private_nh_.setParam(name, value);
  has_changed_ = true;
  ROS_INFO_STREAM("set_parameters: " << name << " is " << value);
}

bool LiveParameters::update(NodeSettings& settings) {
  const std::lock_guard lock(mutex_);
  if (!has_changed_) return false;
  has_changed_ = false;
  for_each_live(settings, [&](const ParameterInfo& info, double& value) {
    for (const Live& live : live_)
      if (live.name == info.name) value = live.value;
  });
  return true;
}

}  // namespace stillmap
