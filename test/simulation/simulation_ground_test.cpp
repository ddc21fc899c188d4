// The height field: slopes, steps, and that no ray steps through it.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/ground.hpp"
#include "simulation/random.hpp"

namespace stillmap::simulation {
namespace {

Ground level_with_sidewalk() {
  Ground ground;
  ground.patches.push_back({{-100, -100}, {100, 100}, 0, surfaces::kRoad});
  ground.patches.push_back({{-100, 4}, {100, 8}, 0.12, surfaces::kSidewalk});
  return ground;
}

Ray downwards(const Eigen::Vector3d& origin, double elevation_deg, double azimuth_deg) {
  const double e = elevation_deg * M_PI / 180, a = azimuth_deg * M_PI / 180;
  return {origin, {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)}};
}

TEST(Ground, LevelGroundIsHitWhereTrigonometrySays) {
  const auto hit = level_with_sidewalk().cross(downwards({0, 0, 1.5}, -30, 0), 100);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->crossing.range_m, 3.0, 2e-3);
  EXPECT_EQ(hit->surface.semantic_class, 40);
}

TEST(Ground, SidewalkIsHigher) {
  const Ground ground = level_with_sidewalk();
  EXPECT_DOUBLE_EQ(ground.height_m(0, 5), 0.12);
  EXPECT_DOUBLE_EQ(ground.height_m(0, 3), 0.0);
  const auto hit = ground.cross({{0, 5, 2}, -Eigen::Vector3d::UnitZ()}, 100);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->crossing.range_m, 1.88, 1e-3);
  EXPECT_EQ(hit->surface.semantic_class, 48);
}

TEST(Ground, RaysUpwardAndTooFarMiss) {
  const Ground ground = level_with_sidewalk();
  EXPECT_FALSE(ground.cross(downwards({0, 0, 1.5}, 5, 0), 100));
  EXPECT_FALSE(ground.cross(downwards({0, 0, 1.5}, -1, 0), 50)) << "it would be hit at 86 m";
}

TEST(Ground, HitsLieOnASlopedWavyGroundAndNothingIsSteppedThrough) {
  Ground ground;
  ground.slope = {0.03, -0.05};
  ground.waves = {{{0.3, 0.2}, 0.2, 0.7}, {{1.9, -1.1}, 0.03, 2.0}};
  ground.patches.push_back({{-200, -200}, {200, 200}, 0, surfaces::kRoad});
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = downwards({0, 0, 2}, random.uniform(-60, -4), random.uniform(0, 360));
    const auto hit = ground.cross(ray, 150);
    if (!hit) continue;
    const Eigen::Vector3d at = ray.origin + hit->crossing.range_m * ray.direction;
    EXPECT_NEAR(at.z(), ground.height_m(at.x(), at.y()), 2e-3);
    for (double range_m = 0.1; range_m < hit->crossing.range_m - 0.05; range_m += 0.05) {
      const Eigen::Vector3d before = ray.origin + range_m * ray.direction;
      ASSERT_GT(before.z(), ground.height_m(before.x(), before.y())) << "ray " << i;
    }
  }
}

TEST(Ground, GrassStandsInTheSamePlaceWheneverLookedAt) {
  Ground ground;
  ground.patches.push_back({{-100, -100}, {100, 100}, 0, surfaces::kGrass});
  const Ray ray = downwards({0, 0, 1.5}, -45, 20);
  const auto first = ground.cross(ray, 100), second = ground.cross(ray, 100);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->crossing.range_m, second->crossing.range_m);
  const double height_m = 1.5 + first->crossing.range_m * ray.direction.z();
  EXPECT_GE(height_m, -1e-3);
  EXPECT_LE(height_m, 0.12 + 1e-3);
}

}  // namespace
}  // namespace stillmap::simulation
