#include "tools/merge_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "io/map_archive.hpp"
#include "io/map_file.hpp"
#include "io/tile_folder.hpp"
#include "io/whole_map.hpp"
#include "maps/map_merge.hpp"
#include "stillmap/mapper.hpp"
#include "tools/map_scans.hpp"
#include "tools/parameter_options.hpp"
#include "tools/say.hpp"
#include "tools/sequence_options.hpp"

namespace stillmap {
namespace {

struct MergeJob {
  std::string out;
  std::vector<std::string> in;
  SequenceOptions sequences;  ///< how to read recordings among `in`
  ParameterOptions parameters;
};

MapContents map_of_sequence(Sequence& sequence, const std::string& name, const Parameters& parameters) {
  const auto far_tiles = open_tile_folder(parameters, say);
  Mapper mapper(parameters);
  mapper.set_tile_store(far_tiles.get());
  map_scans(mapper, sequence, 0, name);
  std::mutex nobody_else;
  return contents_of(whole_map(mapper, far_tiles.get(), nobody_else));
}

MapContents map_of(const std::string& path, const MergeJob& job, const Parameters& parameters) {
  if (std::filesystem::path(path).extension() == ".stillmap") return read_map_archive(path);
  SequenceOptions options = job.sequences;
  options.path = path;
  return map_of_sequence(*options.open(), path, parameters);
}

void merge_all(const MergeJob& job) {
  const Parameters parameters = job.parameters.resolve();
  const LogOddsBounds bounds{static_cast<float>(parameters.log_odds_min),
                             static_cast<float>(parameters.log_odds_max)};
  MapContents merged;
  for (const std::string& path : job.in) {
    const MapContents map = map_of(path, job, parameters);
    if (&path == &job.in.front()) {
      merged = map;
      continue;
    }
    try {
      merge(merged, map, bounds);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(path + ": " + error.what());
    }
  }
  save_map(pieces_of(merged), decision_of(parameters), job.out);
  std::size_t voxels = 0;
  for (const BlockContents& block : merged.blocks) voxels += block.voxels.size();
  std::cout << job.out << ": " << voxels << " voxels of " << job.in.size() << " recordings or maps\n";
}

}  // namespace

void add_merge_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("merge", "Maps and recordings of one frame as one map: log-odds add up");
  const auto job = std::make_shared<MergeJob>();
  command->add_option("OUT", job->out, "The map to write: .stillmap, .pcd, .ply, .bt or .ot")->required();
  command->add_option("IN", job->in, "Each a .stillmap, a folder in SemanticKITTI layout or a .bag")
      ->required()
      ->expected(1, -1);
  job->sequences.add_bag_options_to(*command);
  job->parameters.add_to(*command);
  command->callback([job] { merge_all(*job); });
}

}  // namespace stillmap
