// Scans of small worlds whose every point is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation/cast_scan.hpp"
#include "simulation/path.hpp"

namespace stillmap::simulation {
namespace {

std::uint32_t semantic_class(std::uint32_t label) {
  return label & 0xffffU;
}

SensorMotion standing_at(double x, double y, double z) {
  return [=](double) { return pose_at(x, y, z); };
}

SimulatedFrame scan_at(const World& world, const SensorMotion& motion, double middle_s,
                       double recording_end_s = kNever_s) {
  Sweep sweep;
  sweep.middle_s = middle_s;
  sweep.recording_end_s = recording_end_s;
  return cast_scan(RayCaster(world), sensor_model("vlp16"), motion, sweep, ReturnNoise::none());
}

/// A box that starts to move at 5 s.
World world_with_late_starter() {
  World world;
  world.add_ground(0, surfaces::kRoad);
  Mover box;
  box.body = {{make_box(pose_at(0, 0, 1), {1, 1, 2}, surfaces::kMetal)}};
  const auto profile = SpeedProfile::starting(5, 1);
  box.motion = along(Path({{8, 0}, {30, 0}}), profile, world.ground);
  box.first_move_s = profile.first_move_s();
  box.class_moving = kMovingPerson;
  box.class_standing = kPerson;
  world.add_mover(box);
  return world;
}

TEST(CastScan, PointsLieOnTheWallTheyAreLabelledAs) {
  World world;
  world.add_ground(0, surfaces::kRoad);
  world.add_box(pose_at(10, 0, 5), {1, 60, 10}, surfaces::kFacade);
  const SimulatedFrame scan = scan_at(world, standing_at(0, 0, 1.5), 0);
  ASSERT_EQ(scan.labels.size(), scan.frame.scan.points.size());
  std::size_t on_wall = 0;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    const Eigen::Vector3f& point = scan.frame.scan.points[i];
    if (semantic_class(scan.labels[i]) == 50) {
      ++on_wall;
      EXPECT_NEAR(point.x(), 9.5, 1e-3);
    } else {
      EXPECT_EQ(semantic_class(scan.labels[i]), 40U);
      EXPECT_NEAR(point.z(), -1.5, 2e-3);
    }
  }
  EXPECT_GT(on_wall, 1000U);
}

TEST(CastScan, RingsLieAtTheirElevations) {
  World world;
  world.add_ground(0, surfaces::kRoad);
  world.add_cylinder(pose_at(12, 0, 5), 3, 40, surfaces::kFacade);
  const SensorModel sensor = sensor_model("vlp16");
  const SimulatedFrame scan = scan_at(world, standing_at(0, 0, 1.5), 0);
  for (std::size_t i = 0; i < scan.ring.size(); ++i) {
    const Eigen::Vector3f& point = scan.frame.scan.points[i];
    const double elevation_deg = std::asin(point.z() / point.norm()) * 180 / M_PI;
    EXPECT_NEAR(elevation_deg, sensor.ring_elevations_deg[scan.ring[i]], 1e-3);
  }
}

TEST(CastScan, LabelNowSwitchesWhenTheStanderStarts) {
  const World world = world_with_late_starter();
  const auto classes = [&](double time_s, auto member) {
    const SimulatedFrame scan = scan_at(world, standing_at(0, 0, 1.5), time_s);
    std::vector<std::uint32_t> found;
    for (const std::uint32_t label : scan.*member) {
      if (semantic_class(label) != 40 &&
          std::find(found.begin(), found.end(), semantic_class(label)) == found.end()) {
        found.push_back(semantic_class(label));
      }
    }
    return found;
  };
  using Classes = std::vector<std::uint32_t>;
  EXPECT_EQ(classes(4.9, &SimulatedFrame::labels_now), Classes{kPerson});
  EXPECT_EQ(classes(5.1, &SimulatedFrame::labels_now), Classes{kMovingPerson});
  EXPECT_EQ(classes(0.0, &SimulatedFrame::labels), Classes{kMovingPerson});
}

TEST(CastScan, WhatMovesOnlyAfterTheRecordingStands) {
  const World world = world_with_late_starter();
  const SimulatedFrame scan = scan_at(world, standing_at(0, 0, 1.5), 0, 4.0);
  const auto is_moving = [](std::uint32_t label) { return semantic_class(label) > 250; };
  EXPECT_TRUE(std::none_of(scan.labels.begin(), scan.labels.end(), is_moving));
}

TEST(CastScan, PointsAreCompensatedForTheSensorsOwnMotion) {
  World world;
  world.add_box(pose_at(0, 20, 5), {400, 1, 10}, surfaces::kFacade);
  const auto driving = [](double time_s) { return pose_at(10 * time_s, 0, 1.5, 0.5 * time_s); };
  const SimulatedFrame scan = scan_at(world, driving, 1.0);
  EXPECT_TRUE(scan.T_map_sensor_true.isApprox(driving(1.0)));
  EXPECT_EQ(scan.frame.scan.stamp_ns, 1'000'000'000);
  ASSERT_GT(scan.frame.scan.points.size(), 1000U);
  for (const Eigen::Vector3f& point : scan.frame.scan.points) {
    EXPECT_NEAR((scan.T_map_sensor_true * point.cast<double>()).y(), 19.5, 1e-3);
  }
}

TEST(CastScan, NoiseSpreadsRangesBySigma) {
  World world;
  world.add_box(pose_at(10, 0, 0), {1, 100, 100}, surfaces::kFacade);
  ReturnNoise noise = ReturnNoise::none();
  noise.range_noise_m = 0.05;
  noise.drop_share = 0.2;
  const auto clean = scan_at(world, standing_at(0, 0, 0), 0);
  const auto noisy = cast_scan(RayCaster(world), sensor_model("vlp16"), standing_at(0, 0, 0), Sweep{}, noise);
  const auto count = static_cast<double>(noisy.frame.scan.points.size());
  EXPECT_NEAR(count / static_cast<double>(clean.frame.scan.points.size()), 0.8, 0.02);
  double squares = 0;
  for (const Eigen::Vector3f& point : noisy.frame.scan.points) {
    const double range_m = point.cast<double>().norm();
    const double true_range_m = 9.5 * range_m / point.cast<double>().x();
    squares += (range_m - true_range_m) * (range_m - true_range_m);
  }
  EXPECT_NEAR(std::sqrt(squares / count), 0.05, 0.003);
}

}  // namespace
}  // namespace stillmap::simulation
