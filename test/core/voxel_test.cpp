#include "stillmap/voxel.hpp"

#include <gtest/gtest.h>

namespace stillmap {
namespace {

const Eigen::Vector3f kMiddle = Eigen::Vector3f::Constant(0.5F);

TEST(Voxel, LogOddsRoundToTheNearestStep) {
  Voxel voxel;
  voxel.set_log_odds(1.0F);
  EXPECT_EQ(voxel.log_odds_fixed, 2048);
  voxel.set_log_odds(-0.25F);
  EXPECT_EQ(voxel.log_odds_fixed, -512);
  for (float value = -4.0F; value <= 4.0F; value += 0.0137F) {
    voxel.set_log_odds(value);
    EXPECT_NEAR(voxel.log_odds(), value, 0.5F / Voxel::kLogOddsScale + 1e-6F);
  }
}

TEST(Voxel, SurfaceOffsetIsKeptInThirtySecondths) {
  for (float x = 0; x < 1; x += 0.01F) {
    Voxel voxel;
    const Eigen::Vector3f offset(x, 1 - x, 0.5F * x);
    voxel.hit(offset);
    EXPECT_LE((voxel.surface_offset() - offset).cwiseAbs().maxCoeff(), 1.0F / 64 + 1e-6F);
  }
}

TEST(Voxel, SurfaceOffsetFollowsTheReturns) {
  // 0.25 is kept as (8 + 0.5) / 32 = 0.265625; a quarter of the way to 0.75 is 0.38671875, kept as (12 + 0.5)
  // / 32.
  Voxel voxel;
  voxel.hit(Eigen::Vector3f::Constant(0.25F));
  EXPECT_FLOAT_EQ(voxel.surface_offset().x(), 0.265625F);
  voxel.hit(Eigen::Vector3f::Constant(0.75F));
  EXPECT_FLOAT_EQ(voxel.surface_offset().y(), 0.390625F);
}

TEST(Voxel, SeveralReturnsOfOneScanAreOneHit) {
  Voxel voxel;
  for (int i = 0; i < 5; ++i) voxel.hit(kMiddle);
  EXPECT_EQ(voxel.hits, 1);
  voxel.idle = 1;  // the next scan
  voxel.hit(kMiddle);
  EXPECT_EQ(voxel.hits, 2);
  EXPECT_EQ(voxel.idle, 0);
}

TEST(Voxel, CountsSaturate) {
  Voxel voxel;
  for (int scan = 0; scan < 1000; ++scan) {
    voxel.idle = 1;
    voxel.hit(kMiddle);
    voxel.see_through();
  }
  EXPECT_EQ(voxel.hits, 255);
  EXPECT_EQ(voxel.seen_through, 63);
}

TEST(Voxel, CameBackIfHitAgainAfterItWasSeenThrough) {
  Voxel voxel;
  voxel.hit(kMiddle);
  voxel.idle = 2;
  voxel.hit(kMiddle);
  EXPECT_FALSE(voxel.came_back) << "never seen through";
  voxel.see_through();
  voxel.idle = 1;
  voxel.hit(kMiddle);
  EXPECT_FALSE(voxel.came_back) << "it was not away for a scan";
  voxel.idle = 2;
  voxel.hit(kMiddle);
  EXPECT_TRUE(voxel.came_back);
  voxel.hit(kMiddle);
  EXPECT_TRUE(voxel.came_back) << "another return of the same scan";
  voxel.idle = 1;
  voxel.hit(kMiddle);
  EXPECT_TRUE(voxel.came_back) << "once porous, always porous";
}

}  // namespace
}  // namespace stillmap
