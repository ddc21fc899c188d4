#include "simulation/simulator.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "simulation/cast_scan.hpp"
#include "simulation/odometry.hpp"
#include "simulation/scene.hpp"

namespace stillmap {
namespace {

void require(bool is_valid, const char* option, double seen, const char* allowed) {
  if (is_valid) return;
  throw std::invalid_argument(std::string("simulation option ") + option + " is " + std::to_string(seen) +
                              ": give " + allowed);
}

void check(const SimulationOptions& options) {
  require(options.rate_hz >= 0.1 && options.rate_hz <= 100, "rate_hz", options.rate_hz, "0.1 to 100");
  const double speed_mps = options.ego_speed_mps.value_or(0);
  require(speed_mps >= 0 && speed_mps <= 60, "ego_speed_mps", speed_mps, "0 to 60");
  require(options.pose_noise_m >= 0 && options.pose_noise_m <= 1, "pose_noise_m", options.pose_noise_m,
          "0 to 1");
  require(options.pose_noise_deg >= 0 && options.pose_noise_deg <= 10, "pose_noise_deg",
          options.pose_noise_deg, "0 to 10");
  require(options.drift_percent >= 0 && options.drift_percent <= 20, "drift_percent", options.drift_percent,
          "0 to 20");
  require(options.range_noise_m >= 0 && options.range_noise_m <= 1, "range_noise_m", options.range_noise_m,
          "0 to 1");
  require(options.drop_percent >= 0 && options.drop_percent <= 100, "drop_percent", options.drop_percent,
          "0 to 100");
}

SimulationOptions filled(SimulationOptions options) {
  check(options);
  const simulation::SceneKind& kind = simulation::scene_kind(options.scene);
  if (options.sensor.empty()) options.sensor = kind.sensor;
  if (options.scans == 0) options.scans = kind.scans;
  if (!options.ego_speed_mps) options.ego_speed_mps = kind.ego_speed_mps;
  return options;
}

simulation::SensorModel sensor_of(const SimulationOptions& options) {
  simulation::SensorModel sensor = simulation::sensor_model(options.sensor);
  if (options.columns == 0) return sensor;
  require(sensor.pattern == simulation::ScanPattern::kSpinning && options.columns <= 4096, "columns",
          static_cast<double>(options.columns), "at most 4096, to a sensor that spins");
  sensor.columns = options.columns;
  return sensor;
}

double duration_s(const SimulationOptions& options) {
  return static_cast<double>(options.scans) / options.rate_hz;
}

std::vector<Eigen::Isometry3d> sensor_poses(const simulation::Scene& scene,
                                            const SimulationOptions& options) {
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t k = 0; k < options.scans; ++k) {
    poses.push_back(scene.T_map_sensor_at(static_cast<double>(k) / options.rate_hz));
  }
  return poses;
}

}  // namespace

struct Simulator::State {
  explicit State(const SimulationOptions& given)
      : options(filled(given)),
        sensor(sensor_of(options)),
        scene(simulation::scene_kind(options.scene)
                  .make({options.seed, duration_s(options), *options.ego_speed_mps})),
        caster(scene.world),
        odometry(simulation::odometry_poses(
            sensor_poses(scene, options),
            {options.seed, options.pose_noise_m, options.pose_noise_deg, options.drift_percent})) {}

  SimulationOptions options;
  simulation::SensorModel sensor;
  simulation::Scene scene;
  simulation::RayCaster caster;
  std::vector<Eigen::Isometry3d> odometry;
};

Simulator::Simulator(const SimulationOptions& options) : state_(std::make_unique<const State>(options)) {}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

std::size_t Simulator::size() const {
  return state_->options.scans;
}

SimulatedFrame Simulator::frame(std::size_t k) const {
  const SimulationOptions& options = state_->options;
  if (k >= size()) {
    throw std::invalid_argument("scan " + std::to_string(k) + " of a simulation of " +
                                std::to_string(size()) + " scans: give a smaller number");
  }
  simulation::Sweep sweep;
  sweep.middle_s = static_cast<double>(k) / options.rate_hz;
  sweep.period_s = 1 / options.rate_hz;
  sweep.index = k;
  sweep.seed = options.seed;
  sweep.recording_end_s = static_cast<double>(size() - 1) / options.rate_hz + sweep.period_s / 2;
  simulation::ReturnNoise noise;
  noise.range_noise_m = options.range_noise_m;
  noise.drop_share = options.drop_percent / 100;
  SimulatedFrame frame =
      cast_scan(state_->caster, state_->sensor, state_->scene.T_map_sensor_at, sweep, noise);

  char name[32];
  std::snprintf(name, sizeof(name), "%06zu", k);
  frame.frame.name = name;
  frame.frame.T_map_sensor = state_->odometry[k];
  return frame;
}

std::vector<Frame> Simulator::frames() const {
  std::vector<Frame> all;
  for (std::size_t k = 0; k < size(); ++k) all.push_back(frame(k).frame);
  return all;
}

std::vector<std::string> Simulator::scene_names() {
  std::vector<std::string> names;
  for (const simulation::SceneKind& kind : simulation::scene_kinds()) names.push_back(kind.name);
  return names;
}

std::vector<std::string> Simulator::sensor_names() {
  return simulation::sensor_model_names();
}

}  // namespace stillmap
