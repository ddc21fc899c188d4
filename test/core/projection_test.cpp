#include "stillmap/projection.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stillmap {
namespace {

constexpr float kPi = 3.14159265358979F;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(FastAtan2, StaysWithinItsBound) {
  for (int i = -400000; i <= 400000; ++i) {
    const double angle = 3.141592653589 * i / 400000;
    const auto y = static_cast<float>(std::sin(angle)), x = static_cast<float>(std::cos(angle));
    ASSERT_NEAR(fast_atan2(y, x), std::atan2(static_cast<double>(y), static_cast<double>(x)), 4e-6) << angle;
  }
}

TEST(FastAtan2, OnTheAxes) {
  EXPECT_EQ(fast_atan2(0.0F, 0.0F), 0.0F);
  EXPECT_FLOAT_EQ(fast_atan2(0.0F, 3.0F), 0.0F);
  EXPECT_FLOAT_EQ(fast_atan2(3.0F, 0.0F), kPi / 2);
  EXPECT_FLOAT_EQ(fast_atan2(-3.0F, 0.0F), -kPi / 2);
  EXPECT_FLOAT_EQ(fast_atan2(0.0F, -3.0F), kPi);
}

TEST(Spherical, ByHand) {
  const Spherical left = spherical({0, 2, 0});
  EXPECT_NEAR(left.azimuth_rad, kPi / 2, 4e-6F);
  EXPECT_FLOAT_EQ(left.elevation_rad, 0);
  EXPECT_FLOAT_EQ(left.range_m, 2);
  const Spherical up = spherical({-1, -1, std::sqrt(2.0F)});
  EXPECT_NEAR(up.azimuth_rad, -0.75F * kPi, 4e-6F);
  EXPECT_NEAR(up.elevation_rad, kPi / 4, 4e-6F);
  EXPECT_FLOAT_EQ(up.range_m, 2);
}

ProjectedScan projected(const std::vector<Eigen::Vector3f>& points) {
  Scan scan;
  scan.points = points;
  ProjectedScan result;
  project(scan, 0.5F, 100.0F, result);
  return result;
}

TEST(Project, RowStaysRowAndBadRowsAreNotJudged) {
  const ProjectedScan p = projected({{10, 0, 0},
                                     {kNaN, 1, 1},
                                     {0, 0, 0},
                                     {0.1F, 0, 0},
                                     {0, 0, 200},
                                     {0, 20, 0},
                                     {kInfinity, 0, 0},
                                     {-kInfinity, kInfinity, kNaN}});
  EXPECT_EQ(p.range_m, (std::vector<float>{10, 0, 0, 0, -1, 20, 0, 0}));
  EXPECT_EQ(p.judged, 2U);
}

TEST(Project, BothRangeLimitsAreJudged) {
  EXPECT_EQ(projected({{0.5F, 0, 0}, {100, 0, 0}}).judged, 2U);
}

TEST(Project, ElevationBoundsAreThoseOfTheJudgedRows) {
  const ProjectedScan p = projected({{10, 0, 10}, {10, 0, -10}, {0, 0, 200}, {0, 0, -0.1F}});
  EXPECT_NEAR(p.elevation_max_rad, kPi / 4, 4e-6F);
  EXPECT_NEAR(p.elevation_min_rad, -kPi / 4, 4e-6F);
}

TEST(Project, NothingToJudge) {
  for (const auto& points : {std::vector<Eigen::Vector3f>{}, {{kNaN, kNaN, kNaN}, {0, 0, 0}}}) {
    const ProjectedScan p = projected(points);
    EXPECT_EQ(p.judged, 0U);
    EXPECT_EQ(p.elevation_min_rad, 0.0F);
    EXPECT_EQ(p.elevation_max_rad, 0.0F);
  }
}

}  // namespace
}  // namespace stillmap
