// Beam spacing found from scans alone, on patterns whose spacing is known.
#include "stillmap/sensor_geometry.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/made_scans.hpp"

namespace stillmap {
namespace {

const Rings kSensors[] = {{16, 1800, -15, 15},
                          {32, 2170, -30.67F, 10.67F},
                          {64, 1024, -22.5F, 22.5F},
                          {64, 2083, -24.8F, 2},
                          {128, 1024, -22.5F, 22.5F}};

TEST(SensorGeometry, FindsTheRingsOfEverySensor) {
  for (const Rings& sensor : kSensors) {
    const SensorGeometry found = measure_geometry(projected(sensor.scan(ground_and_wall(1.7F, 40))));
    EXPECT_NEAR(found.ring_spacing_rad / kRad, sensor.spacing_deg(), 0.1F * sensor.spacing_deg());
    EXPECT_NEAR(found.azimuth_step_rad / kRad, sensor.step_deg(), 0.1F * sensor.step_deg());
  }
}

// Beams at whole degrees lie where two rows meet: noise sends some of their returns to the row above.
TEST(SensorGeometry, FindsStepsOfRingsThatNoiseMakesUneven) {
  std::mt19937 random(1);
  std::normal_distribution<float> noise_rad(0, 0.02F * kRad);
  const Rings sensor = kSensors[0];
  Scan scan = sensor.scan(ground_and_wall(1.7F, 40));
  for (Eigen::Vector3f& point : scan.points) point.z() += point.norm() * noise_rad(random);
  const SensorGeometry found = measure_geometry(projected(scan));
  EXPECT_NEAR(found.ring_spacing_rad / kRad, sensor.spacing_deg(), 0.1F * sensor.spacing_deg());
  EXPECT_NEAR(found.azimuth_step_rad / kRad, sensor.step_deg(), 0.1F * sensor.step_deg());
}

// As two sensors above each other on one roof, whose clouds are one: their steps have nothing to do with each
// other.
TEST(SensorGeometry, TwoSensorsInOneCloudHaveRings) {
  const Rings lower = kSensors[1];
  Scan scan = lower.scan(ground_and_wall(1.7F, 40));
  const float turn_rad = 0.3F * lower.step_deg() * kRad;
  for (const Eigen::Vector3f& point : lower.scan(ground_and_wall(1.6F, 40)).points)
    scan.points.emplace_back(Eigen::AngleAxisf(turn_rad, Eigen::Vector3f::UnitZ()) * point);
  const SensorGeometry found = measure_geometry(projected(scan));
  EXPECT_NEAR(found.ring_spacing_rad / kRad, lower.spacing_deg(), 0.1F * lower.spacing_deg());
  EXPECT_LT(found.azimuth_step_rad / kRad, lower.step_deg());
  EXPECT_TRUE(found.has_rings());
}

TEST(SensorGeometry, ReturnsAnywhereHaveTheirMeanSpacing) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> azimuth_deg(-40, 40), elevation_deg(-12, 12);
  Scan scan;
  for (int i = 0; i < 12000; ++i)
    scan.points.emplace_back(10 * direction(azimuth_deg(random) * kRad, elevation_deg(random) * kRad));
  const SensorGeometry found = measure_geometry(projected(scan));
  EXPECT_NEAR(found.ring_spacing_rad / kRad, 0.4F, 0.04F);  // 80 x 24 square degrees
  EXPECT_FALSE(found.has_rings());
}

TEST(SensorGeometry, ARosetteHasAFineSpacing) {
  // 24000 returns in a cone of 70 degrees: on average 0.4 degrees apart.
  Scan scan;
  for (int i = 0; i < 24000; ++i) {
    const float t = static_cast<float>(i) / 24000;
    const float a = 12.1567F * 2 * 3.1415927F * t, b = -7.7733F * 2 * 3.1415927F * t;
    scan.points.emplace_back(10 * direction(17.6F * kRad * (std::cos(a) + std::cos(b)),
                                            18.7F * kRad * (std::sin(a) + std::sin(b))));
  }
  const SensorGeometry found = measure_geometry(projected(scan));
  EXPECT_GT(found.ring_spacing_rad, 0.03F * kRad);
  EXPECT_LT(found.ring_spacing_rad, 1 * kRad);
  EXPECT_GT(found.azimuth_step_rad, 0.02F * kRad);
  EXPECT_LT(found.azimuth_step_rad, 1 * kRad);
}

TEST(SensorGeometry, TooFewReturnsTellNothing) {
  const Scan scan = Rings{4, 8, -10, 10}.scan([](float, float) { return 5.0F; });
  const SensorGeometry found = measure_geometry(projected(scan));
  EXPECT_EQ(found.ring_spacing_rad, 0.0F);
  EXPECT_EQ(found.azimuth_step_rad, 0.0F);
}

TEST(GeometryEstimator, KeepsWhatIsGiven) {
  GeometryEstimator estimator({2 * kRad, 0});
  const Rings sensor = kSensors[2];
  const SensorGeometry geometry = estimator.update(projected(sensor.scan(ground_and_wall(1.7F, 40))));
  EXPECT_FLOAT_EQ(geometry.ring_spacing_rad, 2 * kRad);
  EXPECT_NEAR(geometry.azimuth_step_rad / kRad, sensor.step_deg(), 0.1F * sensor.step_deg());
}

TEST(GeometryEstimator, AssumesSomethingUntilAScanCanTell) {
  GeometryEstimator estimator({0, 0});
  const SensorGeometry before = estimator.update(projected(Scan{}));
  EXPECT_GT(before.ring_spacing_rad, 0.0F);
  EXPECT_GT(before.azimuth_step_rad, 0.0F);
  const Rings sensor = kSensors[0];
  const SensorGeometry after = estimator.update(projected(sensor.scan(ground_and_wall(1.7F, 40))));
  EXPECT_NEAR(after.ring_spacing_rad / kRad, 2.0F, 0.2F);
}

TEST(GeometryEstimator, IsFixedAfterTenScans) {
  GeometryEstimator estimator({0, 0});
  const ProjectedScan sixteen = projected(kSensors[0].scan(ground_and_wall(1.7F, 40)));
  const ProjectedScan many = projected(kSensors[4].scan(ground_and_wall(1.7F, 40)));
  SensorGeometry geometry;
  for (int scan = 0; scan < 10; ++scan) geometry = estimator.update(sixteen);
  const float fixed = geometry.ring_spacing_rad;
  for (int scan = 0; scan < 30; ++scan) geometry = estimator.update(many);
  EXPECT_EQ(geometry.ring_spacing_rad, fixed);
}

}  // namespace
}  // namespace stillmap
