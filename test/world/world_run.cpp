#include "world/world_run.hpp"

#include <cstdio>

#include "simulation/odometry.hpp"

namespace stillmap::simulation {
namespace {

struct Tally {
  std::size_t part = 0, all = 0;
  void add(bool counts) {
    part += counts;
    ++all;
  }
  double percent() const {
    return all > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(all) : -1;
  }
};

}  // namespace

std::vector<JudgedScan> run(Mapper* mapper, const World& world, const SensorMotion& motion,
                            const RunOptions& options) {
  const double gap_s = 1 / options.scan_rate_hz;
  std::vector<Eigen::Isometry3d> poses;
  for (int k = 0; k < options.scans; ++k) poses.push_back(motion(k * gap_s));
  poses = odometry_poses(poses, {1, options.pose_noise_m, options.pose_noise_deg, options.drift_percent});
  const RayCaster caster(world);
  const SensorModel sensor = sensor_model(options.sensor);
  std::vector<JudgedScan> scans;
  for (int k = 0; k < options.scans; ++k) {
    Sweep sweep;
    sweep.middle_s = k * gap_s;
    sweep.index = static_cast<std::uint64_t>(k);
    JudgedScan scan{cast_scan(caster, sensor, motion, sweep, options.noise), {}};
    scan.truth.frame.T_map_sensor = poses[static_cast<std::size_t>(k)];
    scan.online = mapper->process(scan.truth.frame.scan, scan.truth.frame.T_map_sensor);
    scans.push_back(std::move(scan));
    if (options.after_scan) options.after_scan(k);
  }
  return scans;
}

std::vector<JudgedScan> run(const World& world, const SensorMotion& motion, const RunOptions& options) {
  Mapper mapper{on_two_threads()};
  return run(&mapper, world, motion, options);
}

SensorMotion standing_at(double x, double y, double height_m) {
  return [=](double) { return pose_at(x, y, height_m); };
}

SensorMotion driving(double speed_mps, double height_m) {
  return [=](double time_s) { return pose_at(speed_mps * time_s, 0, height_m); };
}

bool is_moving(std::uint32_t label) {
  const std::uint32_t semantic_class = label & 0xFFFFU;
  return semantic_class >= 251 && semantic_class <= 259;
}
bool is_standing(std::uint32_t label) {
  return !is_moving(label);
}
Kind of_class(std::uint16_t semantic_class) {
  return [=](std::uint32_t label) { return (label & 0xFFFFU) == semantic_class; };
}

double percent(const std::vector<JudgedScan>& scans, std::size_t from, std::size_t to, const Kind& kind,
               Label label) {
  Tally tally;
  for (std::size_t k = from; k < to; ++k)
    for (std::size_t row = 0; row < scans[k].online.label.size(); ++row)
      if (kind(scans[k].truth.labels_now[row])) tally.add(scans[k].online.label[row] == label);
  return tally.percent();
}

double percent(const JudgedScan& scan, const Kind& kind, Label label) {
  return percent({scan}, 0, 1, kind, label);
}

double percent_kept(const Mapper& mapper, const std::vector<JudgedScan>& scans, const Kind& kind) {
  Tally tally;
  for (const JudgedScan& scan : scans) {
    const Frame& frame = scan.truth.frame;
    const ScanLabels settled = mapper.relabel(frame.scan, frame.T_map_sensor, scan.online);
    for (std::size_t row = 0; row < settled.label.size(); ++row)
      if (kind(scan.truth.labels_now[row])) tally.add(settled.label[row] != Label::kDynamic);
  }
  return tally.percent();
}

double percent_of_voxels(const Mapper& mapper, const Eigen::AlignedBox3d& box, Label label) {
  Tally tally;
  const MapSnapshotPtr snapshot = mapper.snapshot();
  for (const SnapshotVoxel& voxel : snapshot->voxels)
    if (box.contains(voxel.center.cast<double>())) tally.add(voxel.label == label);
  return tally.percent();
}

double measured(const std::string& what, double value) {
  std::printf("  %s: %.2f\n", what.c_str(), value);
  return value;
}

}  // namespace stillmap::simulation
