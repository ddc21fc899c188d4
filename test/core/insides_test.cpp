// What is seen through the windows of a moving vehicle goes with it.
#include <gtest/gtest.h>

#include <cmath>

#include "core/outline.hpp"
#include "core/receding_van.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {
namespace {

TEST(Outline, HoldsWhatLiesBehindItAcrossTheSeam) {
  Outline outline;
  for (const float azimuth : {3.1F, -3.1F}) {
    outline.add(azimuth, 0.0F, 10.0F, -10.0F, 0.4F * std::copysign(1.0F, azimuth));
    outline.add(azimuth, 0.1F, 10.0F, -10.0F, 0.4F * std::copysign(1.0F, azimuth));
  }
  EXPECT_EQ(outline.rows(), 4);
  EXPECT_NEAR(outline.length_m(), 0.8F, 1e-5F);
  EXPECT_TRUE(outline.holds(3.14F, 0.05F, 11.0F, 3.0F));
  EXPECT_TRUE(outline.holds(-3.14F, 0.05F, 12.9F, 3.0F));
  EXPECT_FALSE(outline.holds(3.0F, 0.05F, 11.0F, 3.0F)) << "beside it";
  EXPECT_FALSE(outline.holds(3.14F, 0.2F, 11.0F, 3.0F)) << "above it";
  EXPECT_FALSE(outline.holds(3.14F, 0.05F, 13.1F, 3.0F)) << "too deep";
  EXPECT_FALSE(outline.holds(3.14F, 0.05F, 9.0F, 3.0F)) << "before it";
}

double share_of_inside_that_moves(bool take_insides_along) {
  Parameters parameters;
  parameters.take_insides_along = take_insides_along;
  Mapper mapper(parameters);
  const Van van;
  int inside = 0, moving = 0;
  for (int k = 0; k < 20; ++k) {
    const Scan scan = van.at(k);
    const ScanLabels& labels = mapper.process(scan, Eigen::Isometry3d::Identity());
    if (k < 8) continue;
    for (std::size_t row = 0; row < scan.points.size(); ++row) {
      const Eigen::Vector3f& p = scan.points[row];
      const float azimuth = std::atan2(p.y(), p.x()), elevation = std::atan2(p.z(), std::hypot(p.x(), p.y()));
      if (!van.covers(azimuth, elevation, k) || p.x() < van.back_m(k) + 0.5F) continue;
      ++inside;
      moving += labels.label[row] == Label::kDynamic;
    }
  }
  EXPECT_GT(inside, 300);
  return static_cast<double>(moving) / inside;
}

TEST(Insides, GoWithTheVehicle) {
  EXPECT_GT(share_of_inside_that_moves(true), 0.8);
  EXPECT_LT(share_of_inside_that_moves(false), 0.2);
}

}  // namespace
}  // namespace stillmap
