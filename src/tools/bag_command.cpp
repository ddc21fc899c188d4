#include "tools/bag_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "io/semantickitti_folder.hpp"
#include "messages/bag_writer.hpp"
#include "tools/progress_bar.hpp"

namespace stillmap {
namespace {

struct BagJob {
  std::string sequence, out;
  std::string frame = "world";
};

void write_bag(const BagJob& job) {
  SemanticKittiFolder sequence(job.sequence);
  BagTopics topics;
  topics.world_clouds = job.frame == "world";
  BagWriter bag(job.out, topics);
  ProgressBar progress("bag", sequence.size());
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    bag.write(sequence.read(k), {});
    progress.advance();
  }
}

}  // namespace

void add_bag_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("bag", "Turn a SemanticKITTI folder into a bag: /cloud_registered, /Odometry, /tf");
  const auto job = std::make_shared<BagJob>();
  command->add_option("SEQUENCE", job->sequence, "Folder in SemanticKITTI layout")->required();
  command->add_option("OUT", job->out, "The .bag")->required();
  command->add_option("--frame", job->frame, "Of the clouds: world or sensor")
      ->check(CLI::IsMember({"world", "sensor"}))
      ->capture_default_str();
  command->callback([job] { write_bag(*job); });
}

}  // namespace stillmap
