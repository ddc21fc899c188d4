#include "tools/label_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "tools/label_run.hpp"
#include "tools/parameter_options.hpp"
#include "tools/sequence_options.hpp"

namespace stillmap {
namespace {

struct LabelOptions {
  SequenceOptions sequence;
  ParameterOptions parameters;
  LabelJob job;
};

void add_part_options(CLI::App& command, LabelJob& job) {
  const std::string group = "Part of the sequence";
  command.add_option("--from", job.from, "First scan")->capture_default_str()->group(group);
  command.add_option("--scans", job.scans, "At most so many scans; 0 = all")
      ->capture_default_str()
      ->group(group);
  command.add_option("--stride", job.stride, "Every so many scans")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->group(group);
}

}  // namespace

void add_label_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "label", "Label every point of a recorded sequence: at once, and by the map after the last scan");
  const auto options = std::make_shared<LabelOptions>();
  options->sequence.add_to(*command);
  command
      ->add_option(
          "OUT", options->job.out,
          "Folder for online/*.label, delayed/*.label, final/*.label (9 static, 251 dynamic, 0 neither), "
          "static_map.pcd and summary.json")
      ->required();
  options->parameters.add_to(*command);
  add_part_options(*command, options->job);
  command
      ->add_option("--delay", options->job.delay,
                   "Also OUT/delayed/*.label: each scan judged again so many scans later; 0 = not")
      ->capture_default_str();
  command->add_flag("!--no-final", options->job.final_labels, "Do not judge again by the final map");
  command->callback([options] {
    const Parameters parameters = options->parameters.resolve();
    label_sequence(*options->sequence.open(), parameters, options->job);
  });
}

}  // namespace stillmap
