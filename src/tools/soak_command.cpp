#include "tools/soak_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "tools/parameter_options.hpp"
#include "tools/sequence_options.hpp"
#include "tools/soak_run.hpp"

namespace stillmap {
namespace {

struct SoakOptions {
  SequenceOptions sequence;
  ParameterOptions parameters;
  SoakJob job;
};

}  // namespace

void add_soak_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "soak", "Drive a sequence in laps, on and on, and watch what a scan costs and what memory grows");
  const auto options = std::make_shared<SoakOptions>();
  SoakJob& job = options->job;
  options->sequence.add_to(*command);
  options->parameters.add_to(*command);
  command->add_option("--scans", job.scans, "How many; three laps at least")->capture_default_str();
  command->add_option("--rows", job.rows, "Of the table, at most; one has three laps at least")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  const auto limit = [&](const char* name, double& value, const char* help) {
    command->add_option(name, value, help)->check(CLI::NonNegativeNumber)->group("Fails above (0 = never)");
  };
  limit("--most-mb", job.most_mb, "Resident memory, MB");
  limit("--most-mb-per-km", job.most_mb_per_km, "Its growth over the second half of the way, MB per km");
  limit("--most-cost-ratio", job.most_cost_ratio, "CPU time of the last lap against a map of one lap");
  limit("--most-different-percent", job.most_different_percent,
        "Labels of a row's last lap that such a map gives otherwise, %");
  command->callback([options] {
    const Parameters parameters = options->parameters.resolve();
    soak(*options->sequence.open(), parameters, options->job);
  });
}

}  // namespace stillmap
