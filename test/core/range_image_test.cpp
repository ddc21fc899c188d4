// The range images against slow, obvious ones (reference_range_image.hpp), and by hand.
#include "stillmap/range_image.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/made_scans.hpp"
#include "core/reference_range_image.hpp"

namespace stillmap {
namespace {

constexpr float kMaxRangeM = 100.0F;
constexpr float kStepM = kMaxRangeM / 65000;

/// Random returns in the rings of a sensor: walls at all distances, every fifth beam without a return. One
/// return below them all, so that no ring lies on the boundary of two rows.
ProjectedScan ragged(const Rings& sensor, int seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> range_m(1, 95), share(0, 1);
  float wall_m = 10;
  Scan scan = sensor.scan([&](float, float) {
    if (share(random) < 0.05F) wall_m = range_m(random);
    return share(random) < 0.2F ? 0.0F : wall_m + share(random);
  });
  scan.points.emplace_back(30 * direction(1, (sensor.lowest_deg - 1.234F) * kRad));
  return projected(scan);
}

std::vector<reference::Direction> returns_of(const ProjectedScan& scan) {
  std::vector<reference::Direction> returns;
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (scan.range_m[i] > 0) returns.push_back({scan.azimuth_rad[i], scan.elevation_rad[i], scan.range_m[i]});
  return returns;
}

/// Asks both at random directions. A direction or a return that float and double rounding put into different
/// pixels may differ: at most one in a thousand.
void expect_same(const RangeImage& image, const reference::RangeImage& plain, int seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> azimuth(-3.1415F, 3.1415F), elevation(-0.6F, 0.6F);
  constexpr int kAsked = 100000;
  int differ = 0, valid = 0;
  for (int i = 0; i < kAsked; ++i) {
    const float a = azimuth(random), e = elevation(random);
    const MeasuredRange fast = image.at(a, e);
    const auto slow = plain.at({a, e, 0});
    valid += fast.valid();
    if (fast.valid() != slow.has_value() ||
        (slow && (std::abs(fast.nearest_m - slow->nearest_m) > 1.5 * kStepM ||
                  std::abs(fast.farthest_m - slow->farthest_m) > 1.5 * kStepM)))
      ++differ;
  }
  EXPECT_LE(differ, kAsked / 1000);
  EXPECT_GT(valid, kAsked / 10);
}

TEST(RangeImage, NearestMatchesTheSlowOne) {
  for (const float level_deg : {2.6F, 2.1F, 1.7F}) {
    const ProjectedScan scan = ragged({64, 1024, -22.5F, 22.5F}, 6);
    expect_same(RangeImage::nearest(scan, level_deg * kRad, kMaxRangeM),
                reference::RangeImage::nearest(returns_of(scan), level_deg * kRad, kMaxRangeM), 7);
  }
}

TEST(RangeImage, BracketedMatchesTheSlowOne) {
  for (const Rings& sensor :
       {Rings{16, 1800, -15, 15}, Rings{32, 2170, -30.67F, 10.67F}, Rings{64, 1024, -22.5F, 22.5F}}) {
    const ProjectedScan scan = ragged(sensor, 8);
    const SensorGeometry geometry{sensor.spacing_deg() * kRad, sensor.step_deg() * kRad};
    expect_same(RangeImage::bracketed(scan, geometry, kMaxRangeM),
                reference::RangeImage::bracketed(returns_of(scan), geometry.ring_spacing_rad,
                                                 geometry.azimuth_step_rad, kMaxRangeM),
                9);
  }
}

TEST(RangeImage, WithoutRingsItMatchesTheSlowOneToo) {
  const ProjectedScan scan = ragged({64, 1024, -22.5F, 22.5F}, 8);
  const SensorGeometry geometry{0.5F * kRad, 0.5F * kRad};
  ASSERT_FALSE(geometry.has_rings());
  expect_same(RangeImage::bracketed(scan, geometry, kMaxRangeM),
              reference::RangeImage::bracketed(returns_of(scan), 0.5F * kRad, 0.5F * kRad, kMaxRangeM), 9);
}

TEST(RangeImage, NearestReturnOfAPixelWins) {
  Scan scan;
  for (const float range_m : {20.0F, 8.0F, 12.0F})
    scan.points.emplace_back(range_m * direction(0.01F, 0.01F));
  const RangeImage image = RangeImage::nearest(projected(scan), 2.5F * kRad, kMaxRangeM);
  const MeasuredRange measured = image.at(0.01F, 0.01F);
  EXPECT_NEAR(measured.nearest_m, 8, kStepM);
  EXPECT_EQ(measured.nearest_m, measured.farthest_m);
  EXPECT_FALSE(image.at(1.0F, 0.01F).valid());
  EXPECT_FALSE(image.at(0.01F, 1.0F).valid()) << "above the image";
}

TEST(RangeImage, BetweenTwoRingsBothOfThemCount) {
  // Rings 2 degrees apart, on the ground 1.7 m below: at -10 degrees 9.79 m, at -8 degrees 12.22 m.
  const Rings sensor{16, 1800, -30, 0};
  const ProjectedScan scan = projected(sensor.scan(ground_and_wall(1.7F, 60)));
  const RangeImage image =
      RangeImage::bracketed(scan, {sensor.spacing_deg() * kRad, sensor.step_deg() * kRad}, kMaxRangeM);
  const MeasuredRange between = image.at(0.5F, -9.0F * kRad);
  EXPECT_NEAR(between.nearest_m, 1.7 / std::sin(10 * kRad), 0.01);
  EXPECT_NEAR(between.farthest_m, 1.7 / std::sin(8 * kRad), 0.01);
  EXPECT_FALSE(image.at(0.5F, -30.4F * kRad).valid()) << "nothing passes below the lowest beam";
  EXPECT_FALSE(image.at(0.5F, -35.0F * kRad).valid());
}

TEST(RangeImage, AzimuthWrapsAround) {
  const Rings sensor{16, 1800, -15, 15};
  const ProjectedScan scan = projected(sensor.scan([](float, float) { return 10.0F; }));
  const RangeImage image =
      RangeImage::bracketed(scan, {sensor.spacing_deg() * kRad, sensor.step_deg() * kRad}, kMaxRangeM);
  for (const float azimuth : {-3.14159265F, 3.14159265F, 3.1415F, -3.1415F})
    EXPECT_NEAR(image.at(azimuth, 0.0F).nearest_m, 10, kStepM) << azimuth;
}

TEST(RangeImage, AScanWithoutReturnsSaysNothing) {
  const ProjectedScan empty = projected(Scan{});
  EXPECT_FALSE(RangeImage::nearest(empty, 2.0F * kRad, kMaxRangeM).at(0.1F, 0.0F).valid());
  EXPECT_FALSE(RangeImage::bracketed(empty, {0.5F * kRad, 0.2F * kRad}, kMaxRangeM).at(0.1F, 0.0F).valid());
}

TEST(SphericalGrid, ColumnsDivideTheCircle) {
  const SphericalGrid grid(0.01F, 0.02F, -0.3F, 0.2F);
  EXPECT_EQ(grid.columns, 628);  // floor(2 pi / 0.01)
  EXPECT_NEAR(grid.column_rad * static_cast<float>(grid.columns), 6.2831853F, 1e-4F);
  EXPECT_EQ(grid.rows, 28);  // 0.5 / 0.02, and one more than needed at both ends
  EXPECT_EQ(grid.column(-3.14159F), 0);
  EXPECT_EQ(grid.column(3.14159F), grid.columns - 1);
  EXPECT_EQ(grid.row(-0.31F), 0);
  EXPECT_EQ(grid.pixel(0.0F, -0.4F), -1);
  EXPECT_EQ(grid.pixel(0.0F, 1.0F), -1);
}

}  // namespace
}  // namespace stillmap
