#include "tools/inject_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "evaluation/injected_sequence.hpp"
#include "io/semantickitti_writer.hpp"
#include "tools/progress_bar.hpp"
#include "tools/sequence_options.hpp"

namespace stillmap {
namespace {

struct InjectJob {
  SequenceOptions sequence;
  PartOptions part;
  InjectionOptions injection;
  std::string out;
};

std::unique_ptr<LabelledSequence> open_background(const SequenceOptions& sequence) {
  if (std::filesystem::is_directory(std::filesystem::path(sequence.path) / "labels"))
    return std::make_unique<LabelledFolder>(sequence.path);
  return std::make_unique<StandingSequence>(sequence.open());
}

void inject(const InjectJob& job) {
  InjectedSequence sequence(std::make_unique<SequencePart>(open_background(job.sequence), job.part),
                            job.injection);
  SemanticKittiWriter writer(job.out);
  ProgressBar progress("inject", sequence.size());
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    const LabelledFrame scan = sequence.read(k);
    writer.write(scan.frame, std::vector<float>(scan.labels.size(), 0.0F), scan.labels, scan.labels_now);
    progress.advance();
  }
}

void add_part_options(CLI::App& command, PartOptions& part) {
  part.first = 10;  // the paper's
  part.count = 20;
  const std::string group = "Part of the sequence";
  command.add_option("--from", part.first, "First scan")->capture_default_str()->group(group);
  command.add_option("--scans", part.count, "At most so many scans; 0 = all")
      ->capture_default_str()
      ->group(group);
  command.add_option("--stride", part.stride, "Every so many scans")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->group(group);
}

void add_target_options(CLI::App& command, InjectionOptions& injection) {
  const std::string group = "Targets";
  const auto add = [&](const char* name, auto& value, const char* help) {
    command.add_option(name, value, help)->capture_default_str()->group(group);
  };
  add("--people", injection.people, "How many");
  add("--person-points", injection.person_points, "Of one person in one scan, if nothing hides them");
  add("--person-height", injection.person_height_m, "m");
  add("--vehicles", injection.vehicles, "How many");
  add("--vehicle-points", injection.vehicle_points, "Of one vehicle in one scan, if nothing hides them");
  command.add_option("--vehicle-size", injection.vehicle_size_m, "Length, width, height, m")
      ->expected(3)
      ->capture_default_str()
      ->group(group);
  add("--speed", injection.speed_mps, "Of all targets, m/s");
  command
      .add_flag("--overlay", injection.overlay,
                "Points all over the targets, which hide nothing and are never hidden")
      ->group(group);
  add("--seed", injection.seed, "Of the paths and every random choice");
  add("--max-points", injection.max_points, "Of the recorded scan, chosen at random; 0 = all");
}

}  // namespace

void add_inject_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "inject", "Put moving people and a vehicle into a recorded sequence, with labels (as for table 3)");
  const auto job = std::make_shared<InjectJob>();
  job->sequence.add_to(*command);
  command->add_option("OUT", job->out, "Folder to write in SemanticKITTI layout; intensity is 0")->required();
  add_part_options(*command, job->part);
  add_target_options(*command, job->injection);
  command->callback([job] { inject(*job); });
}

}  // namespace stillmap
