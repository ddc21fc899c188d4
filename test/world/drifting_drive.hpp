#pragma once

#include "simulation/path.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {

inline constexpr int kScans = 150;
inline constexpr double kSpeed_mps = 6;

inline World building_in_a_yard() {
  World world;
  world.add_ground(0, surfaces::kRoad);
  for (const double side : {-18.0, 18.0}) {
    add_wall(&world, {-18, side}, {18, side}, 0.3, 4, surfaces::kWall);
    add_wall(&world, {side, -18}, {side, 18}, 0.3, 4, surfaces::kWall);
  }
  world.add_box(pose_at(0, 0, 3), {12, 12, 6}, surfaces::kWall);
  Random random(5);
  for (const double x : {-14.0, -9.0, 3.0, 9.0}) add_parked_car(&world, {x, -15.5}, 0.1, &random);
  for (const double y : {-8.0, 4.0, 12.0}) add_pole(&world, {15.5, y}, 0.15, 3.5);
  return world;
}

/// Once around, and a little farther.
inline SensorMotion around_the_building(const Ground& ground) {
  const Path path({{-4, -11}, {11, -11}, {11, 11}, {-11, 11}, {-11, -11}, {11, -11}});
  return carried(path, SpeedProfile::constant(kSpeed_mps), ground, {1.6, 0.1, 0, 0});
}

/// What an odometry says whose error grows with the way, to 1 m and 1 degree.
inline Eigen::Isometry3d drifted(const Eigen::Isometry3d& T_map_sensor, int scan) {
  const double share = static_cast<double>(scan) / (kScans - 1);
  return Eigen::Translation3d(0.8 * share, -0.6 * share, 0) *
         Eigen::AngleAxisd(share * M_PI / 180, Eigen::Vector3d::UnitZ()) * T_map_sensor;
}

/// The drive as the odometry has it, and where the sensor really was.
struct Drive {
  std::vector<SimulatedFrame> frames;

  Drive() {
    const World world = building_in_a_yard();
    const RayCaster caster(world);
    const SensorModel sensor = sensor_model("vlp16");
    const SensorMotion motion = around_the_building(world.ground);
    for (int k = 0; k < kScans; ++k) {
      Sweep sweep;
      sweep.middle_s = 0.1 * k;
      sweep.index = static_cast<std::uint64_t>(k);
      frames.push_back(cast_scan(caster, sensor, motion, sweep, {}));
      frames.back().frame.T_map_sensor = drifted(frames.back().T_map_sensor_true, k);
    }
  }
  Mapper mapped(const Parameters& parameters, bool with_true_poses) const {
    Mapper mapper(parameters);
    for (const SimulatedFrame& scan : frames)
      mapper.process(scan.frame.scan, with_true_poses ? scan.T_map_sensor_true : scan.frame.T_map_sensor);
    return mapper;
  }
  /// As a pose graph publishes it: a pose every half second.
  std::vector<StampedPose> corrected_path() const {
    std::vector<StampedPose> path;
    for (std::size_t k = 0; k < frames.size(); k += 5)
      path.push_back({frames[k].frame.scan.stamp_ns, frames[k].T_map_sensor_true});
    return path;
  }
};

}  // namespace stillmap::simulation
