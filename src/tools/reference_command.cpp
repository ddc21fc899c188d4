#include "tools/reference_command.hpp"

#include <stillmap/ClearBox.h>
#include <stillmap/DiffMap.h>
#include <stillmap/ExplainPoint.h>
#include <stillmap/LabelledMap.h>
#include <stillmap/LoadMap.h>
#include <stillmap/RelabelBox.h>
#include <stillmap/SaveMap.h>
#include <stillmap/Status.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <sstream>

#include "io/parameters_yaml.hpp"
#include "ros/node_interface.hpp"
#include "ros/node_parameters.hpp"
#include "ros/odometry_presets.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {
namespace {

std::string text_of(const std::string& value) {
  return value.empty() ? "" : "`" + value + "`";
}
std::string text_of(bool value) {
  return value ? "`true`" : "`false`";
}
std::string text_of(int value) {
  return "`" + std::to_string(value) + "`";
}
std::string text_of(double value) {
  std::ostringstream text;
  text << '`' << value << '`';
  return text.str();
}
std::string text_of(const std::vector<double>& values) {
  std::ostringstream text;
  for (const double value : values) text << (text.tellp() > 0 ? ", " : "`[") << value;
  return text.str() + "]`";
}

std::string range_of(const ParameterInfo& info, const std::string&) {
  std::string options = info.options;
  for (std::size_t bar = options.find('|'); bar != std::string::npos; bar = options.find('|', bar))
    options.replace(bar, 1, ", ");
  return options;
}
std::string range_of(const ParameterInfo&, bool) {
  return "";
}
template <class Number>
std::string range_of(const ParameterInfo& info, const Number&) {
  std::ostringstream text;
  text << info.min << " to " << info.max << (*info.unit ? " " : "") << info.unit;
  return text.str();
}

struct PrintRow {
  template <class Value>
  void operator()(const ParameterInfo& info, const Value& value) const {
    std::cout << "| `" << info.name << "` | " << text_of(value) << " | " << range_of(info, value) << " | "
              << info.help << " |\n";
  }
};

void print_endpoints(const std::vector<Endpoint>& endpoints) {
  std::cout << "| name | type | what |\n|---|---|---|\n";
  for (const Endpoint& endpoint : endpoints)
    std::cout << "| `~" << endpoint.name << "` | " << endpoint.type << " | " << endpoint.help << " |\n";
}

/// The definition without those of the messages in it.
template <class Message>
void print_definition(const std::string& title) {
  const std::string all = ros::message_traits::Definition<Message>::value();
  std::cout << "\n" << title << "\n\n```\n" << all.substr(0, all.find("\n====")) << "\n```\n";
}

template <class Service>
void print_service(const std::string& name) {
  print_definition<typename Service::Request>("`stillmap/" + name + "`, request");
  print_definition<typename Service::Response>("`stillmap/" + name + "`, response");
}

void print_presets() {
  std::cout << "| `preset` | clouds | poses | `cloud_frame` |\n|---|---|---|---|\n";
  for (const OdometryPreset& preset : odometry_presets()) {
    NodeParameters node;
    apply_odometry_preset(preset.name, node);
    std::cout << "| `" << preset.name << "` | `" << node.cloud_topic << "` | `" << node.odom_topic << "` | `"
              << node.cloud_frame << "` |\n";
  }
}

void print_reference() {
  const NodeParameters node;
  const Parameters method;
  const std::string row = "| parameter | default | values | meaning |\n|---|---|---|---|\n";
  std::cout
      << "# Reference\n\nMade by `stillmap reference`; a test keeps it equal. `~` is the node's own name, "
         "/stillmap by default.\n\n## Parameters of the node\n\n"
      << row;
  visit_node_parameters(node, PrintRow());
  std::cout << "\n## Parameters of the method\n\nOf the preset `default`.\n\n" << row;
  visit_parameters(method, PrintRow());
  std::cout << "\n## Topics\n\n";
  print_endpoints(published_topics());
  std::cout << "\n`/diagnostics` has `scans` (rate, drops, times) and `setup` (the doctor's findings).\n\n"
               "## Services\n\n";
  print_endpoints(offered_services());
  std::cout << "\n## Messages\n";
  print_definition<Status>("`stillmap/Status`");
  print_definition<LabelledMap>("`stillmap/LabelledMap`");
  print_service<SaveMap>("SaveMap");
  print_service<LoadMap>("LoadMap");
  print_service<DiffMap>("DiffMap");
  print_service<ExplainPoint>("ExplainPoint");
  print_service<ClearBox>("ClearBox");
  print_service<RelabelBox>("RelabelBox");
}

}  // namespace

void add_reference_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("reference", "Print the reference of parameters, topics, services and messages");
  const auto presets_alone = std::make_shared<bool>(false);
  command->add_flag("--presets", *presets_alone, "Only the odometry packages that are known, as a table");
  command->callback([presets_alone] { *presets_alone ? print_presets() : print_reference(); });
}

}  // namespace stillmap
