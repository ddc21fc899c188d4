#include "tools/export_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "io/map_archive.hpp"
#include "maps/export_map.hpp"
#include "tools/parameter_options.hpp"

namespace stillmap {
namespace {

struct ExportOptions {
  std::string map;
  std::vector<std::string> out;
  ParameterOptions parameters;
};

void export_all(const ExportOptions& options) {
  const Decision decision = decision_of(options.parameters.resolve());
  const MapContents map = read_map_archive(options.map);
  for (const std::string& path : options.out) std::cout << export_map(map, decision, path) << '\n';
}

}  // namespace

void add_export_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("export", "Turn a .stillmap into what other programs read");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("MAP", options->map, "A .stillmap")->required();
  command
      ->add_option("OUT", options->out,
                   "Each a file: .pcd or .ply of the static voxels, .bt or .ot for OctoMap, .png with the "
                   "heights seen from above, .stillmap")
      ->required();
  options->parameters.add_to(*command);
  command->callback([options] { export_all(*options); });
}

}  // namespace stillmap
