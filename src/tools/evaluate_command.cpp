#include "tools/evaluate_command.hpp"

#include <CLI/CLI.hpp>
#include <fstream>
#include <memory>

#include "evaluation/methods.hpp"
#include "tools/evaluate_run.hpp"
#include "tools/parameter_options.hpp"

namespace stillmap {
namespace {

struct EvaluateOptions {
  EvaluateJob job;
  ParameterOptions parameters;
};

void add_input_options(CLI::App& command, EvaluateJob& job) {
  command.add_option("SEQUENCES", job.sequences,
                     "SemanticKITTI folders with labels/ (and labels_now/ where the truth depends on "
                     "time), or folders of such");
  command.add_option("--semantickitti", job.semantic_kitti,
                     "Run this folder (sequences/00) as in table 2: scans 0 to 19, at most 8000 points each");
  command.add_option("--treescope", job.treescope.path,
                     "Run this as in table 3: a folder of `stillmap inject`, or UCM-0822-11.bag, of which "
                     "scans 10 to 29 then get targets and at most 9000 points each");
  job.treescope.cloud_frame = "sensor";
  job.treescope.cloud_topic = "/os_node/segmented_point_cloud_no_destagger";
  job.treescope.odom_topic = "/Odometry";
  job.treescope.add_bag_options_to(command);
}

void add_part_options(CLI::App& command, PartOptions& part) {
  const std::string group = "Part of each of SEQUENCES";
  command.add_option("--from", part.first, "First scan")->capture_default_str()->group(group);
  command.add_option("--scans", part.count, "At most so many scans; 0 = all")
      ->capture_default_str()
      ->group(group);
  command.add_option("--stride", part.stride, "Every so many scans")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->group(group);
  command.add_option("--max-points", part.max_points, "Of each scan, chosen at random; 0 = all")
      ->capture_default_str()
      ->group(group);
}

/// The words that this process was started with.
std::string command_line() {
  std::ifstream words("/proc/self/cmdline", std::ios::binary);
  std::string line;
  for (std::string word; std::getline(words, word, '\0');) line += (line.empty() ? "" : " ") + word;
  return line;
}

}  // namespace

void add_evaluate_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "evaluate", "Measure methods on labelled sequences, all on the same points, and write a report");
  const auto options = std::make_shared<EvaluateOptions>();
  EvaluateJob& job = options->job;
  add_input_options(*command, job);
  command->add_option("--out", job.out, "Folder for the report")->required();
  job.methods = method_names();
  command->add_option("--methods", job.methods, "Which ones")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(method_names()))
      ->capture_default_str();
  command->add_option("--delay", job.delay, "Scans until the delayed verdicts; 0 = none")
      ->capture_default_str();
  command->add_flag("--ablation", job.ablation,
                    "Instead of --methods: the default, and the default without each of its additions");
  command->add_flag("--brief", job.brief, "Neither map-wise figures nor pictures, which take long");
  command->add_flag("!--no-figures", job.figures, "Tables only");
  add_part_options(*command, job.part);
  command->add_option("--seed", job.part.seed, "Of every random choice")->capture_default_str();
  options->parameters.add_to(*command);
  command->callback([options] { evaluate(options->job, options->parameters.resolve(), command_line()); });
}

}  // namespace stillmap
