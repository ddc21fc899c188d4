#include "baselines/erasor.hpp"

#include <gtest/gtest.h>

#include "baselines/polar_bins.hpp"
#include "removal_check.hpp"

namespace stillmap {
namespace {

const Eigen::Vector3d kOrigin(0, 0, 1.7), kCarLow(6, -1, 0.3), kCarHigh(10, 1, 1.5), kRoofLow(6, -1, 2.2),
    kRoofHigh(10, 1, 2.4), kTreeLow(8, 5, 0), kTreeHigh(8.4, 5.4, 2.5);

std::vector<Frame> car_leaves(bool under_roof) {
  SmallWorld full, empty;
  empty.add_box(kTreeLow, kTreeHigh);
  full = empty;
  full.add_box(kCarLow, kCarHigh);
  if (under_roof) full.add_box(kRoofLow, kRoofHigh);
  std::vector<Frame> frames(3, full.scan(kOrigin));
  for (int k = 1; k <= 5; ++k) frames.push_back(empty.scan(kOrigin + Eigen::Vector3d(0.1 * k, 0, 0)));
  return frames;
}

TEST(Erasor, RemovesACarOnFlatGround) {
  const std::vector<Frame> frames = car_leaves(false);
  Erasor method(ErasorSettings::published());
  const RemovalCheck check(method, frames);
  EXPECT_GT(check.removed_share(kCarLow, kCarHigh), 0.9);
  EXPECT_LT(check.removed_share({-20, -20, -0.05}, {20, 20, 0.05}), 0.01);  // the ground
  EXPECT_LT(check.removed_share(kTreeLow + Eigen::Vector3d(0, 0, 0.3), kTreeHigh), 0.01);
}

TEST(Erasor, SpoilsWhatHangsOver) {  // a bin has one span of heights, whatever is in it
  const std::vector<Frame> frames = car_leaves(true);
  Erasor method(ErasorSettings::published());
  EXPECT_GT(RemovalCheck(method, frames).removed_share(kRoofLow, kRoofHigh), 0.9);
}

TEST(Erasor, GroundClearanceProtectsWhatIsLow) {
  const std::vector<Frame> frames = car_leaves(false);
  ErasorSettings settings = ErasorSettings::published();
  settings.gates.height_above_ground_m = 0.8;
  Erasor method(settings);
  const RemovalCheck check(method, frames);
  EXPECT_LT(check.removed_share(kCarLow, {10, 1, 0.55}), 0.01);
  EXPECT_GT(check.removed_share({6, -1, 1.15}, kCarHigh), 0.9);
}

TEST(PolarBins, KnowTheirVolumeAndSpan) {
  const PolarBins::Layout layout{10, 36, 50.0, -2.0, 1.0};
  EXPECT_EQ(layout.bin_of({60, 0, 0}), -1);
  EXPECT_EQ(layout.bin_of({5, 0, 1.5}), -1);
  EXPECT_EQ(layout.bin_of({7, 0.1, 0}), 1 * 36 + 18);
  PolarBins bins(layout);
  bins.add({7, 0.1, -1.5}, 0);
  bins.add({7, 0.2, 0.5}, 1);
  const PolarBins::Bin& bin = bins.bins()[36 + 18];
  EXPECT_DOUBLE_EQ(bin.span_m(), 2.0);
  EXPECT_EQ(bin.members, (std::vector<std::uint32_t>{0, 1}));
}

TEST(GroundPlane, FollowsASlopeAndLeavesObjects) {
  std::vector<Eigen::Vector3d> points;
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 10; ++y) points.emplace_back(0.2 * x, 0.2 * y, 0.1 * 0.2 * x);
  for (int i = 0; i < 30; ++i) points.emplace_back(1.0, 1.0, 0.4 + 0.05 * i);
  const std::vector<std::uint8_t> ground = find_ground(points, {});
  EXPECT_EQ(std::count(ground.begin(), ground.begin() + 100, 1), 100);
  EXPECT_EQ(std::count(ground.begin() + 100, ground.end(), 1), 0);
}

TEST(GroundPlane, TooFewPointsAreGround) {
  EXPECT_EQ(find_ground({{0, 0, 0}, {0, 0, 2}}, {}), (std::vector<std::uint8_t>{1, 1}));
}

}  // namespace
}  // namespace stillmap
