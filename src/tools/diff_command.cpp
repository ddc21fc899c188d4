#include "tools/diff_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "io/atomic_file.hpp"
#include "io/map_archive.hpp"
#include "io/map_file.hpp"
#include "maps/change_list.hpp"
#include "tools/parameter_options.hpp"

namespace stillmap {
namespace {

struct DiffJob {
  std::string first, second, out;
  DiffOptions options;
  ParameterOptions parameters;
};

void compare(const DiffJob& job) {
  const Decision decision = decision_of(job.parameters.resolve());
  const MapDiff found =
      diff(read_map_archive(job.first), read_map_archive(job.second), decision, job.options);
  std::cout << table_of(found);
  if (job.out.empty()) return;
  const std::filesystem::path out(job.out);
  std::filesystem::create_directories(out);
  save_map(snapshot_of(found.appeared, found), (out / "appeared.pcd").string());
  save_map(snapshot_of(found.gone, found), (out / "gone.pcd").string());
  write_text_atomically((out / "changes.csv").string(), csv_of(found));
  const std::string picture = (out / "diff.png").string();
  std::cout << picture << ": " << save_diff_picture(found, picture) << '\n';
}

}  // namespace

void add_diff_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("diff", "What appeared and what went between two maps of one frame");
  const auto job = std::make_shared<DiffJob>();
  command->add_option("FIRST", job->first, "The earlier .stillmap")->required();
  command->add_option("SECOND", job->second, "The later .stillmap")->required();
  command->add_option("--out", job->out, "Folder for appeared.pcd, gone.pcd, changes.csv and diff.png");
  command
      ->add_option("--tolerance-voxels", job->options.tolerance_voxels,
                   "Surface that the other map has so near is the same")
      ->check(CLI::Range(0, 10))
      ->capture_default_str();
  command
      ->add_option("--mapped-within-m", job->options.mapped_within_m,
                   "The other map must have something so near, else it was not there and cannot tell")
      ->check(CLI::Range(0.0, 50.0))
      ->capture_default_str();
  command
      ->add_option("--least-height-m", job->options.least_height_m,
                   "Lower changes are left out: ground that something hid in one session")
      ->capture_default_str();
  command->add_option("--least-voxels", job->options.least_voxels, "Smaller changes are left out")
      ->capture_default_str();
  job->parameters.add_to(*command);
  command->callback([job] { compare(*job); });
}

}  // namespace stillmap
