#include "tools/simulate_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>
#include <string>

#include "io/semantickitti_writer.hpp"
#include "simulation/simulator.hpp"
#include "tools/progress_bar.hpp"

#if STILLMAP_WITH_ROS
#include "messages/bag_writer.hpp"
#endif

namespace stillmap {
namespace {

struct SimulateJob {
  SimulationOptions simulation;
  std::string out;
  std::string bag_frame = "world";
};

bool is_bag(const std::string& path) {
  return path.size() > 4 && path.compare(path.size() - 4, 4, ".bag") == 0;
}

void simulate_to_folder(const SimulateJob& job) {
  const Simulator simulator(job.simulation);
  SemanticKittiWriter writer(job.out);
  ProgressBar progress("simulate", simulator.size());
  for (std::size_t k = 0; k < simulator.size(); ++k) {
    const SimulatedFrame scan = simulator.frame(k);
    writer.write(scan.frame, scan.intensity, scan.labels, scan.labels_now);
    progress.advance();
  }
}

#if STILLMAP_WITH_ROS
void simulate_to_bag(const SimulateJob& job) {
  const Simulator simulator(job.simulation);
  BagTopics topics;
  topics.world_clouds = job.bag_frame == "world";
  BagWriter writer(job.out, topics);
  ProgressBar progress("simulate", simulator.size());
  for (std::size_t k = 0; k < simulator.size(); ++k) {
    SimulatedFrame scan = simulator.frame(k);
    writer.write(scan.frame, {std::move(scan.intensity), std::move(scan.ring), std::move(scan.labels)});
    progress.advance();
  }
}
#else
void simulate_to_bag(const SimulateJob& job) {
  throw std::runtime_error(
      job.out + ": this build has no bag support: name a folder, or build with STILLMAP_WITH_ROS=ON");
}
#endif

void add_world_options(CLI::App& command, SimulationOptions& options) {
  command.add_option("--sensor", options.sensor, "The LiDAR; the scene has its own")
      ->check(CLI::IsMember(Simulator::sensor_names()));
  command.add_option("--columns", options.columns, "Of a turn, if it spins; 0 = the sensor's own")
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Changes layout, counts, speeds and noise")
      ->capture_default_str();
  command.add_option("--scans", options.scans, "How many; 0 = as the scene is made for")
      ->capture_default_str();
  command.add_option("--rate-hz", options.rate_hz, "Sweeps in a second")->capture_default_str();
  command.add_option("--ego-speed", options.ego_speed_mps, "Of the sensor, m/s; the scene has its own");
}

void add_noise_options(CLI::App& command, SimulationOptions& options) {
  const std::string group = "Noise";
  const auto add = [&](const char* name, double& value, const char* help) {
    command.add_option(name, value, help)->capture_default_str()->group(group);
  };
  add("--pose-noise-m", options.pose_noise_m, "Sigma of each pose along each axis, m");
  add("--pose-noise-deg", options.pose_noise_deg, "Sigma of each pose about each axis, degrees");
  add("--drift-percent", options.drift_percent, "Drift of the poses, % of the way");
  add("--range-noise-m", options.range_noise_m, "Sigma of each range, m");
  add("--drop-percent", options.drop_percent, "Returns lost at random, %");
}

}  // namespace

void add_simulate_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "simulate", "Record a simulated scene with known truth, as a SemanticKITTI folder or a bag");
  const auto job = std::make_shared<SimulateJob>();
  command->add_option("SCENE", job->simulation.scene, "The world")
      ->required()
      ->check(CLI::IsMember(Simulator::scene_names()));
  command->add_option("OUT", job->out, "A folder, or a file that ends in .bag")->required();
  add_world_options(*command, job->simulation);
  add_noise_options(*command, job->simulation);
  command->add_option("--frame", job->bag_frame, "Of a bag's clouds: world or sensor")
      ->check(CLI::IsMember({"world", "sensor"}))
      ->capture_default_str();
  command->callback([job] { is_bag(job->out) ? simulate_to_bag(*job) : simulate_to_folder(*job); });
}

}  // namespace stillmap
