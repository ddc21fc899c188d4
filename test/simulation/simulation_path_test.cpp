// Speeds, ways, and bodies on the ground.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/path.hpp"
#include "simulation/random.hpp"
#include "simulation/traffic.hpp"

namespace stillmap::simulation {
namespace {

TEST(SpeedProfile, DistanceIsTheIntegralOfSpeed) {
  EXPECT_DOUBLE_EQ(SpeedProfile::constant(2).distance_m(3), 6);
  EXPECT_DOUBLE_EQ(SpeedProfile::constant(2).distance_m(-1), -2);
  const auto starting = SpeedProfile::starting(5, 4);
  EXPECT_DOUBLE_EQ(starting.distance_m(5), 0);
  EXPECT_DOUBLE_EQ(starting.distance_m(5.5), 0.5);  // 4 m/s^2 for half a second
  EXPECT_DOUBLE_EQ(starting.distance_m(7), 2 + 4);
  const auto stopping = SpeedProfile::stopping(3, 2);
  EXPECT_DOUBLE_EQ(stopping.distance_m(3), 5.5);
  EXPECT_DOUBLE_EQ(stopping.distance_m(100), 5.5);
}

TEST(SpeedProfile, StopAndGoStandsInBetween) {
  const auto profile = SpeedProfile::stop_and_go(2, 3, 1, 0);
  EXPECT_DOUBLE_EQ(profile.distance_m(3), 2.5);
  EXPECT_DOUBLE_EQ(profile.distance_m(6), 2.5);
  EXPECT_DOUBLE_EQ(profile.distance_m(9), 5);
}

TEST(SpeedProfile, KnowsItsFirstMove) {
  EXPECT_DOUBLE_EQ(SpeedProfile::starting(5, 4).first_move_s(), 5);
  EXPECT_DOUBLE_EQ(SpeedProfile::stop_and_go(2, 3, 1, 0.7).first_move_s(), 0.7);
  EXPECT_EQ(SpeedProfile::constant(1).first_move_s(), -kNever_s);
  EXPECT_EQ(SpeedProfile::stopping(3, 1).first_move_s(), -kNever_s);
  EXPECT_EQ(SpeedProfile::constant(0).first_move_s(), kNever_s);
}

TEST(Path, GoesFromPointToPoint) {
  const Path path({{0, 0}, {10, 0}, {10, 5}});
  EXPECT_DOUBLE_EQ(path.length_m(), 15);
  EXPECT_TRUE(path.position(12).isApprox(Eigen::Vector2d(10, 2)));
  EXPECT_TRUE(path.position(99).isApprox(Eigen::Vector2d(10, 5))) << "it stays at the end";
  EXPECT_NEAR(path.heading_rad(5, 0.5), 0, 1e-12);
  EXPECT_NEAR(path.heading_rad(10, 0.5), M_PI / 4, 1e-12);
  EXPECT_NEAR(path.heading_rad(15, 0.5), M_PI / 2, 1e-12);
}

TEST(Path, CarTiltsWithTheSlopeAndStaysOnIt) {
  Ground ground;
  ground.slope = {0.1, 0};
  ground.patches.push_back({{-100, -100}, {100, 100}, 0, surfaces::kRoad});
  const auto motion = along(Path({{0, 0}, {50, 0}}), SpeedProfile::constant(10), ground, 0, 2.7);
  const MoverPose pose = motion(2);
  EXPECT_NEAR(pose.distance_m, 20, 1e-12);
  EXPECT_TRUE(pose.T_map_body.translation().isApprox(Eigen::Vector3d(20, 0, 2)));
  const Eigen::Vector3d ahead = pose.T_map_body.linear() * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(ahead.z() / ahead.x(), 0.1, 1e-9);
}

TEST(Path, WanderingGoesAroundWhatStands) {
  Random random(5);
  const Obstacle obstacle{{0, 0}, 2};
  const Path path = wander({Eigen::Vector2d(-10, -10), Eigen::Vector2d(10, 10)}, {obstacle}, 100, &random);
  ASSERT_GE(path.length_m(), 100);
  for (double at_m = 0; at_m < path.length_m(); at_m += 0.1) {
    EXPECT_GT((path.position(at_m) - obstacle.center).norm(), 1.99);
  }
}

}  // namespace
}  // namespace stillmap::simulation
