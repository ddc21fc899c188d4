// The ground found around the sensor: level, sloped, over a step, beside walls.
#include "core/ground.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/made_scans.hpp"

namespace stillmap {
namespace {

const Rings kSensor{64, 1024, -25, 5};
const Eigen::Matrix3f kUpright = Eigen::Matrix3f::Identity();

/// A scan of the ground z(x, y), by marching along each beam, with 2 cm of range noise.
Scan scan_of_ground(const std::function<float(float, float)>& height_m) {
  std::mt19937 random(11);
  std::normal_distribution<float> noise_m(0, 0.02F);
  return kSensor.scan([&](float azimuth, float elevation) {
    const Eigen::Vector3f d = direction(azimuth, elevation);
    for (float range_m = 1; range_m < 70; range_m += 0.02F)
      if (range_m * d.z() <= height_m(range_m * d.x(), range_m * d.y())) return range_m + noise_m(random);
    return 0.0F;
  });
}

Ground fitted_to(const Scan& scan, const Eigen::Matrix3f& R_map_sensor) {
  const ProjectedScan p = projected(scan);
  UprightRows rows;
  rows.turn(p, R_map_sensor);
  Ground ground;
  ground.fit(rows);
  return ground;
}

std::vector<float> heights_above(const Ground& ground, const std::vector<Eigen::Vector3f>& points,
                                 const Eigen::Matrix3f& R_map_sensor) {
  Scan scan;
  scan.points = points;
  UprightRows rows;
  rows.turn(projected(scan), R_map_sensor);
  std::vector<float> heights_m;
  ground.heights_above(rows, heights_m);
  return heights_m;
}

/// Mean and largest error of the ground's height, over all returns nearer than 40 m.
struct Errors {
  double mean_m = 0, largest_m = 0;
};
Errors errors(const Ground& ground, const std::function<float(float, float)>& height_m) {
  std::vector<Eigen::Vector3f> points;
  for (float radius_m = 4; radius_m < 40; radius_m += 0.5F)
    for (float azimuth = -3; azimuth < 3; azimuth += 0.05F) {
      const float x = radius_m * std::cos(azimuth), y = radius_m * std::sin(azimuth);
      points.emplace_back(x, y, height_m(x, y));
    }
  Errors errors;
  for (const float error_m : heights_above(ground, points, kUpright)) {
    errors.mean_m += std::abs(error_m) / static_cast<double>(points.size());
    errors.largest_m = std::max<double>(errors.largest_m, std::abs(error_m));
  }
  return errors;
}

Errors fitted(const std::function<float(float, float)>& height_m) {
  return errors(fitted_to(scan_of_ground(height_m), kUpright), height_m);
}

TEST(Ground, Level) {
  const Errors found = fitted([](float, float) { return -1.7F; });
  EXPECT_LT(found.mean_m, 0.01);
  EXPECT_LT(found.largest_m, 0.05);
}

TEST(Ground, Slope) {
  // Inside a ring of 1 m the height is one number: at 6 % it is off by up to 0.03 m at its edges.
  const Errors found = fitted([](float x, float) { return -1.7F + 0.06F * x; });
  EXPECT_LT(found.mean_m, 0.04);
  EXPECT_LT(found.largest_m, 0.4);  // far out, between two rings, the height is carried on
}

TEST(Ground, Step) {
  const Errors found = fitted([](float, float y) { return y > 5 ? -1.55F : -1.7F; });  // a kerb
  EXPECT_LT(found.mean_m, 0.03);
}

TEST(Ground, WhatStandsOnItIsNotGround) {
  // A wall at x = 10 m. No return comes from the ground behind it, and its lowest return lies up to a beam's
  // spacing (0.08 m) above its foot.
  const Scan scan = kSensor.scan([](float azimuth, float elevation) {
    const Eigen::Vector3f d = direction(azimuth, elevation);
    const float wall_m = d.x() > 0 ? 10 / d.x() : 1e3F, ground_m = d.z() < 0 ? -1.7F / d.z() : 1e3F;
    const float range_m = std::min(wall_m, ground_m);
    return range_m < 70 ? range_m : 0.0F;
  });
  std::vector<Eigen::Vector3f> points;
  for (float z = -1.4F; z < 0; z += 0.1F) points.emplace_back(10, 0.3F, z);
  points.emplace_back(500, 0, 0);
  const std::vector<float> heights_m = heights_above(fitted_to(scan, kUpright), points, kUpright);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) EXPECT_NEAR(heights_m[i], points[i].z() + 1.7F, 0.12F);
  EXPECT_EQ(heights_m.back(), std::numeric_limits<float>::infinity());
}

TEST(Ground, ASensorThatHardlyLooksDownDoesNotTakeThingsForIt) {
  // Its lowest beams meet the ground 14 m away, but for a gap walls all around at 4 m, a metre above it.
  const Rings sensor{64, 1024, -7, 52};
  const Scan scan = sensor.scan([](float azimuth, float elevation) {
    const float ground_m = elevation < 0 ? 1.7F / std::sin(-elevation) : 1e3F;
    const float range_m = std::min(ground_m, std::abs(azimuth) < 0.3F ? 1e3F : 4 / std::cos(elevation));
    return range_m < 70 ? range_m : 0.0F;
  });
  const Ground ground = fitted_to(scan, kUpright);
  EXPECT_GT(heights_above(ground, {{-4, 0, -0.49F}}, kUpright).front(), 1.0F);
  EXPECT_NEAR(heights_above(ground, {{20, 0, -1.7F}}, kUpright).front(), 0, 0.05);
}

TEST(Ground, ASideThatIsMetAboveUnseenGroundIsNotGround) {
  // The lowest beams meet the ground 14 m away, and the side of a van 11 m away 0.35 m above it.
  const Rings sensor{64, 1024, -7, 52};
  const Scan scan = sensor.scan([](float azimuth, float elevation) {
    const Eigen::Vector3f d = direction(azimuth, elevation);
    const float ground_m = d.z() < 0 ? -1.7F / d.z() : 1e3F, van_m = d.x() > 0 ? 11 / d.x() : 1e3F;
    const bool is_van = std::abs(van_m * d.y()) < 2 && van_m * d.z() < 0.3F;
    const float range_m = std::min(ground_m, is_van ? van_m : 1e3F);
    return range_m < 70 ? range_m : 0.0F;
  });
  const Ground ground = fitted_to(scan, kUpright);
  EXPECT_NEAR(heights_above(ground, {{11, 0, -1.3F}}, kUpright).front(), 0.4F, 0.1F);
  EXPECT_NEAR(heights_above(ground, {{20, 9, -1.7F}}, kUpright).front(), 0, 0.05);
}

// A thing 0.15 m wide and 6 cm high, which 16 rings meet once; behind it they meet the
// ground in another cell.
TEST(Ground, BesideAFootLiesTheGroundThatItHides) {
  const Rings sensor{16, 1800, -15, 15};
  constexpr float kHeightM = 1.6F, kFootM = 0.06F, kAwayM = 9.85F;
  const Scan scan = sensor.scan([&](float azimuth, float elevation) {
    const Eigen::Vector3f d = direction(azimuth, elevation);
    const float ground_m = kHeightM / -d.z();
    const Eigen::Vector3f at = kAwayM / d.x() * d;
    const float above_m = at.z() + kHeightM;
    if (d.x() > 0 && std::abs(at.y()) < 0.075F && above_m > 0 && above_m < kFootM) return at.norm();
    return ground_m > 0 && ground_m < 60 ? ground_m : 0.0F;
  });
  const Ground ground = fitted_to(scan, kUpright);
  UprightRows rows;
  rows.turn(projected(scan), kUpright);
  std::vector<float> heights_m;
  ground.heights_above(rows, heights_m);
  int feet = 0;
  for (std::size_t row = 0; row < scan.points.size(); ++row) {
    const Eigen::Vector3f& p = scan.points[row];
    if (std::abs(p.x() - kAwayM) > 0.001F || std::abs(p.y()) >= 0.075F || rows.ground_cell[row] < 0) continue;
    ++feet;
    const float above_m = p.z() + kHeightM;
    EXPECT_LT(heights_m[row], 0.02F) << "taken for the ground";
    EXPECT_NEAR(p.z() - ground.height_beside_m(rows.ground_cell[row]), above_m, 0.02F);
  }
  EXPECT_GT(feet, 2);
}

TEST(Ground, ATiltedSensorSeesTheSameGround) {
  const Eigen::Matrix3f R_map_sensor =
      Eigen::AngleAxisf(0.15F, Eigen::Vector3f(0.6F, 0.8F, 0)).toRotationMatrix();
  const Scan scan = kSensor.scan([&](float azimuth, float elevation) {
    const Eigen::Vector3f d = R_map_sensor * direction(azimuth, elevation);
    return d.z() < -0.03F ? -1.7F / d.z() : 0.0F;
  });
  const std::vector<float> heights_m =
      heights_above(fitted_to(scan, R_map_sensor), scan.points, R_map_sensor);
  for (std::size_t row = 0; row < scan.points.size(); ++row)
    if (scan.points[row].norm() > 1) {
      EXPECT_LT(std::abs(heights_m[row]), 0.02F);
    }
}

TEST(Ground, AnEmptyScanHasOneToo) {
  EXPECT_FLOAT_EQ(heights_above(fitted_to(Scan{}, kUpright), {{5, 0, 1}}, kUpright).front(), 1);
}

}  // namespace
}  // namespace stillmap
