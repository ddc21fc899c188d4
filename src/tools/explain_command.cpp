#include "tools/explain_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>

#include "io/map_archive.hpp"
#include "io/tile_folder.hpp"
#include "io/whole_map.hpp"
#include "maps/explanation_picture.hpp"
#include "stillmap/mapper.hpp"
#include "tools/coordinates.hpp"
#include "tools/map_scans.hpp"
#include "tools/parameter_options.hpp"
#include "tools/say.hpp"
#include "tools/sequence_options.hpp"

namespace stillmap {
namespace {

struct ExplainJob {
  std::string at, picture;
  std::size_t scans = 0;  ///< 0 = all
  SequenceOptions source;
  ParameterOptions parameters;
};

Parameters parameters_for(const ExplainJob& job, const MapContents& map) {
  Parameters parameters = job.parameters.resolve();
  if (map.voxel_size_m > 0) parameters.voxel_size_m = map.voxel_size_m;
  return parameters;
}

void explain_place(const ExplainJob& job) {
  const std::vector<double> at = coordinates(job.at, 3, "--at", "x y z");
  const bool is_map = std::filesystem::path(job.source.path).extension() == ".stillmap";
  const MapContents map = is_map ? read_map_archive(job.source.path) : MapContents{};
  const Parameters parameters = parameters_for(job, map);
  const auto far_tiles = open_tile_folder(parameters, say);
  Mapper mapper(parameters);
  mapper.set_tile_store(far_tiles.get());
  if (is_map)
    mapper.import_map(map);
  else
    map_scans(mapper, *job.source.open(), job.scans, "mapping");
  const Explanation explanation = mapper.explain({at[0], at[1], at[2]});
  std::cout << in_words(explanation) << '\n';
  if (job.picture.empty()) return;
  std::mutex nobody_else;
  const MapSnapshot around = snapshot_of(whole_map(mapper, far_tiles.get(), nobody_else), mapper.decision());
  std::cout << job.picture << ": " << save_explanation_picture(explanation, around, job.picture) << '\n';
}

}  // namespace

void add_explain_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("explain", "Why a place has its label, in words and as a picture");
  const auto job = std::make_shared<ExplainJob>();
  command
      ->add_option(
          "SOURCE", job->source.path,
          "A recording (folder in SemanticKITTI layout or .bag), or a .stillmap, which knows no scans")
      ->required();
  command->add_option("--at", job->at, "The place in the map's frame, metres: \"x y z\"")->required();
  command->add_option("--scans", job->scans, "Only so many scans of the recording; 0 = all")
      ->capture_default_str();
  command->add_option("--picture", job->picture, "A .png of the place from above, with the scans' rays");
  job->source.add_bag_options_to(*command);
  job->parameters.add_to(*command);
  command->callback([job] { explain_place(*job); });
}

}  // namespace stillmap
