// Two LiDARs of different make on one robot, each looking where the other cannot: one map.
#include <gtest/gtest.h>

#include "simulation/path.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"
#include "support/expect_error.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {
namespace {

World yard_with_people() {
  World world;
  world.add_ground(0, surfaces::kRoad);
  for (const double side : {-15.0, 15.0}) {
    add_wall(&world, {-40, side}, {40, side}, 0.3, 6, surfaces::kWall);
    add_wall(&world, {side * 2, -15}, {side * 2, 15}, 0.3, 6, surfaces::kWall);
  }
  Random random(3);
  for (const double x : {9.0, -7.0})
    add_person(&world, Path({{x, -12}, {x, 12}}), SpeedProfile::constant(1.4), &random, 4);
  add_car(&world, Path({{-28, 6}, {28, 6}}), SpeedProfile::constant(7), &random);
  return world;
}

/// One half of the sweep: what the robot does not hide.
SimulatedFrame seen_ahead(SimulatedFrame scan) {
  std::size_t kept = 0;
  for (std::size_t row = 0; row < scan.labels.size(); ++row) {
    if (scan.frame.scan.points[row].x() < 0) continue;
    scan.frame.scan.points[kept] = scan.frame.scan.points[row];
    scan.labels_now[kept++] = scan.labels_now[row];
  }
  scan.frame.scan.points.resize(kept);
  scan.labels_now.resize(kept);
  return scan;
}

struct Lidar {
  std::string model;
  Eigen::Isometry3d T_body_sensor;
};

struct Judged {
  std::vector<JudgedScan> of[2];
};

Judged drive(Mapper* mapper, bool told_apart) {
  const World world = yard_with_people();
  const RayCaster caster(world);
  const Lidar lidars[2] = {
      {"os1_64", Eigen::Isometry3d(Eigen::Translation3d(1.2, 0, 0.2))},
      {"vlp16", Eigen::Translation3d(-1.0, 0.3, -0.3) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ())}};
  Judged judged;
  for (int k = 0; k < 70; ++k) {
    const int i = k % 2;
    Sweep sweep;
    sweep.middle_s = 0.05 * k;  // in turn, each ten times a second
    sweep.index = static_cast<std::uint64_t>(k);
    const SensorMotion body = driving(1.0, 1.6);
    const SensorMotion motion = [&](double time_s) { return body(time_s) * lidars[i].T_body_sensor; };
    JudgedScan scan{seen_ahead(cast_scan(caster, sensor_model(lidars[i].model), motion, sweep, {})), {}};
    scan.truth.frame.scan.sensor = told_apart ? i : 0;
    scan.online = mapper->process(scan.truth.frame.scan, scan.truth.T_map_sensor_true);
    judged.of[i].push_back(std::move(scan));
  }
  return judged;
}

TEST(SeveralLidars, MakeOneMapEachWithItsOwnBeams) {
  Mapper mapper{on_two_threads()};
  const Judged judged = drive(&mapper, true);
  for (const int i : {0, 1}) {
    const auto& scans = judged.of[i];
    const std::string of = " of LiDAR " + std::to_string(i) + ", %";
    EXPECT_GT(measured("moving: dynamic at once" + of, percent(scans, 12, 35, is_moving, Label::kDynamic)),
              80);
    EXPECT_LT(measured("standing: dynamic at once" + of, percent(scans, 5, 35, is_standing, Label::kDynamic)),
              0.5);
    EXPECT_GT(measured("standing: kept" + of, percent_kept(mapper, scans, is_standing)), 99);
  }
  // Only the rear one sees the rear wall, and only the front one the front wall.
  EXPECT_GT(percent_of_voxels(mapper, box({-30.2, -10, 0.5}, {-29.7, 10, 5}), Label::kStatic), 90);
  EXPECT_GT(percent_of_voxels(mapper, box({29.7, -10, 0.5}, {30.2, 10, 5}), Label::kStatic), 90);
}

TEST(SeveralLidars, ANumberOutOfRangeIsRefused) {
  Mapper mapper{on_two_threads()};
  Scan scan;
  for (const int sensor : {-1, 16}) {
    scan.sensor = sensor;
    expect_error<std::invalid_argument>([&] { mapper.process(scan, Eigen::Isometry3d::Identity()); },
                                        {"sensor", "0 to 15"});
  }
  EXPECT_EQ(mapper.scan_count(), 0U);
}

}  // namespace
}  // namespace stillmap::simulation
