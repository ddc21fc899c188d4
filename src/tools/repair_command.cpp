#include "tools/repair_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "io/map_archive.hpp"
#include "io/map_file.hpp"
#include "maps/map_extent.hpp"
#include "stillmap/mapper.hpp"
#include "tools/coordinates.hpp"

namespace stillmap {
namespace {

struct RepairJob {
  std::string in, out;
  std::vector<std::string> clear, relabel;
};

Eigen::AlignedBox3d box_of(const std::string& text, const std::string& option) {
  const std::vector<double> n = coordinates(text, 6, option, "min and max: x y z x y z");
  return {Eigen::Vector3d(n[0], n[1], n[2]), Eigen::Vector3d(n[3], n[4], n[5])};
}

/// "static 1 2 3 4 5 6" as the label and the rest.
std::pair<Label, std::string> split_label(const std::string& text) {
  const std::size_t space = text.find(' ');
  for (const Label label : {Label::kUncertain, Label::kStatic, Label::kDynamic})
    if (text.substr(0, space) == to_string(label) && space != std::string::npos)
      return {label, text.substr(space + 1)};
  throw std::runtime_error("--relabel '" + text +
                           "': begin with static, dynamic or uncertain, then min and max: x y z x y z");
}

void report(const std::string& option, const std::string& box, std::size_t voxels, const MapContents& map) {
  if (voxels == 0)
    throw std::runtime_error(option + " '" + box + "': no voxel is in the box; " +
                             extent_in_words(pieces_of(map)));
  std::cout << option << " '" << box << "': " << voxels << " voxels\n";
}

void repair(const RepairJob& job) {
  if (job.clear.empty() && job.relabel.empty())
    throw std::runtime_error("nothing to do; give --clear or --relabel");
  const MapContents map = read_map_archive(job.in);
  Parameters parameters;
  parameters.voxel_size_m = map.voxel_size_m;
  Mapper mapper(parameters);
  mapper.import_map(map);
  try {
    for (const std::string& box : job.clear)
      report("--clear", box, mapper.clear_box(box_of(box, "--clear")), map);
    for (const std::string& given : job.relabel) {
      const auto [label, box] = split_label(given);
      report("--relabel", given, mapper.relabel_box(box_of(box, "--relabel"), label), map);
    }
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(job.in + ": " + error.what());
  }
  save_map(pieces_of(mapper.export_map()), mapper.decision(), job.out);
}

}  // namespace

void add_repair_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("repair", "Forgets or relabels boxes of a map by hand, cleared ones first");
  const auto job = std::make_shared<RepairJob>();
  command->add_option("IN", job->in, "A .stillmap")->required();
  command->add_option("OUT", job->out, "The map to write, which may be IN: .stillmap, .pcd, .ply, .bt or .ot")
      ->required();
  command->add_option("--clear", job->clear, "A box to forget: \"x y z x y z\", its low and its high corner");
  command->add_option("--relabel", job->relabel,
                      "A box that is static, dynamic or uncertain for certain: \"static x y z x y z\"");
  command->callback([job] { repair(*job); });
}

}  // namespace stillmap
