#include "tools/doctor_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "ros/odometry_presets.hpp"
#include "tools/bag_examination.hpp"
#include "tools/launch_line.hpp"

namespace stillmap {
namespace {

struct DoctorJob {
  std::string bag;
  std::string preset;                        ///< empty = the one whose topics are in the bag
  std::map<std::string, std::string> given;  ///< node parameters, over the preset
};

void print(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) std::cout << "  " << finding.check << ": " << finding.text << '\n';
}

/// Mends what it can and looks again, so that the launch line is one that was tried.
void examine_and_mend(const std::string& bag, NodeParameters node) {
  constexpr int kRounds = 3;
  for (int round = 0;; ++round) {
    std::cout << (round == 0 ? "as given: " : "mended: ") << to_text(node) << '\n';
    const BagExamination seen = examine(bag, node);
    std::cout << "  " << seen.scans << " scans examined, the sensor went " << seen.way_m << " m\n";
    print(seen.findings);
    if (seen.findings.empty()) std::cout << "  nothing found\n";
    bool has_changed = false;
    for (const Finding& finding : seen.findings)
      for (const auto& [name, value] : finding.mend) has_changed |= set_node_parameter(node, name, value);
    if (!has_changed || round + 1 == kRounds) break;
  }
  std::cout << '\n' << launch_line(node, bag) << '\n';
}

void run(const DoctorJob& job) {
  BagContents contents = contents_of(job.bag);
  std::cout << job.bag << ": clouds " << to_text(contents.clouds) << "; poses "
            << (contents.odometry.empty() ? "none" : to_text(contents.odometry)) << '\n';
  NodeParameters node;
  apply_odometry_preset(job.preset.empty() ? preset_for(contents) : job.preset, node);
  for (const auto& [name, value] : job.given) set_node_parameter(node, name, value);
  if (contents.odometry.empty()) {
    std::cout << "  no odometry in the bag: the poses must come from tf2\n\n"
              << launch_line_with_tf(contents, job.bag) << '\n';
    return;
  }
  choose_topics(contents, node);
  examine_and_mend(job.bag, node);
}

}  // namespace

void add_doctor_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("doctor",
                                         "Examine the first scans of a bag: stamps, frames, axes, ray "
                                         "origin, density; and propose the launch line");
  const auto job = std::make_shared<DoctorJob>();
  command->add_option("BAG", job->bag, "The recording")->required()->check(CLI::ExistingFile);
  std::vector<std::string> names;
  for (const OdometryPreset& preset : odometry_presets()) names.push_back(preset.name);
  command->add_option("--preset", job->preset, "The odometry package; else found by its topics")
      ->check(CLI::IsMember(names));
  for (const char* name : {"cloud_topic", "odom_topic", "cloud_frame", "sensor_on_body", "odometry_axes"}) {
    std::string option = std::string("--") + name;
    std::replace(option.begin(), option.end(), '_', '-');
    command->add_option_function<std::string>(
        option, [job, name](const std::string& value) { job->given[name] = value; },
        "As the launch file's argument");
  }
  command->callback([job] { run(*job); });
}

}  // namespace stillmap
