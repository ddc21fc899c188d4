// What the coarse image turns away, the scan says nothing about.
#include "core/coarse_image.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/made_scans.hpp"
#include "core/scan_view.hpp"

namespace stillmap {
namespace {

constexpr float kMaxRangeM = 100.0F;

/// Walls at all distances, some beams without a return.
ProjectedScan ragged(int seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> range_m(1, 60), share(0, 1);
  float wall_m = 10;
  const Rings sensor{32, 900, -24, 10};
  return projected(sensor.scan([&](float, float) {
    if (share(random) < 0.02F) wall_m = range_m(random);
    return share(random) < 0.1F ? 0.0F : wall_m + 0.3F * share(random);
  }));
}

void expect_no_block_missed(const RangeImage& image, const LevelModel& level, int seed) {
  const CoarseImage coarse(image, level);
  std::mt19937 random(seed);
  std::normal_distribution<float> normal(0, 1);
  std::uniform_real_distribution<float> range_m(0.5F, 70), share(0, 1);
  constexpr int kBalls = 20000, kPoints = 50;
  int turned_away = 0;
  for (int ball = 0; ball < kBalls; ++ball) {
    const Eigen::Vector3f towards(normal(random), normal(random), 0.4F * normal(random));
    const Eigen::Vector3f center = range_m(random) * towards.normalized();
    const float radius_m = 0.2F + share(random);
    if (coarse.may_tell(spherical(center), radius_m)) continue;
    ++turned_away;
    for (int i = 0; i < kPoints; ++i) {
      const Eigen::Vector3f off(normal(random), normal(random), normal(random));
      const Spherical s = spherical(center + radius_m * std::cbrt(share(random)) * off.normalized());
      const Evidence evidence = classify(s.range_m, image.at(s.azimuth_rad, s.elevation_rad), level);
      ASSERT_NE(evidence, Evidence::kSupport) << s.range_m;
      ASSERT_NE(evidence, Evidence::kConflict) << s.range_m;
    }
  }
  EXPECT_GT(turned_away, kBalls / 10);
  EXPECT_LT(turned_away, kBalls * 9 / 10);
}

TEST(CoarseImage, NothingThatABracketedImageTellsIsTurnedAway) {
  const LevelModel level = level_models(Parameters{}).front();
  for (const int seed : {1, 2, 3}) {
    const ProjectedScan scan = ragged(seed);
    expect_no_block_missed(RangeImage::bracketed(scan, measure_geometry(scan), kMaxRangeM), level, seed);
  }
}

TEST(CoarseImage, NothingThatCoarsePixelsTellIsTurnedAway) {
  const LevelModel level = level_models(Parameters{}).front();
  expect_no_block_missed(RangeImage::nearest(ragged(4), 0.035F, kMaxRangeM), level, 4);
}

}  // namespace
}  // namespace stillmap
