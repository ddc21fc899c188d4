#include "baselines/removert.hpp"

#include <gtest/gtest.h>

#include "removal_check.hpp"

namespace stillmap {
namespace {

const Eigen::Vector3d kOrigin(0, 0, 1.7), kCarLow(6, -1, 0.3), kCarHigh(10, 1, 1.5), kWallLow(15, -8, 0),
    kWallHigh(16, 8, 3);

TEST(Removert, RemovesWhatScansSeeThrough) {
  SmallWorld full, empty;
  full.add_box(kWallLow, kWallHigh);
  empty = full;
  full.add_box(kCarLow, kCarHigh);
  std::vector<Frame> frames = {full.scan(kOrigin)};
  for (int k = 1; k <= 4; ++k) frames.push_back(empty.scan(kOrigin + Eigen::Vector3d(0.1 * k, 0.02 * k, 0)));
  Removert method(RemovertSettings::published());
  const RemovalCheck check(method, frames);
  EXPECT_GT(check.removed_share({6, -1, 0.5}, kCarHigh), 0.8);
  EXPECT_LT(check.removed_share(kWallLow + Eigen::Vector3d(0, 0, 0.3), kWallHigh), 0.02);
}

/// A point at 5 m, which the second scan passes by within a fine pixel, but hits beside it.
std::vector<Frame> edge_of_a_thing() {
  const auto at = [](double azimuth_deg, double range_m) {
    const double azimuth = azimuth_deg * M_PI / 180;
    return Eigen::Vector3f(static_cast<float>(range_m * std::cos(azimuth)),
                           static_cast<float>(range_m * std::sin(azimuth)),
                           static_cast<float>(0.02 * range_m));
  };
  std::vector<Frame> frames(2);
  frames[0].scan.points = {at(0.1, 5)};
  frames[1].scan.points = {at(0.2, 10), at(0.7, 5)};
  return frames;
}

TEST(Removert, RevertsAtCoarseLevels) {
  const std::vector<Frame> frames = edge_of_a_thing();
  RemovertSettings settings;
  settings.remove_pixels_deg = {0.4};
  settings.revert_pixels_deg = {};
  Removert remove_only(settings);
  RemovalCheck removed(remove_only, frames);
  EXPECT_EQ(remove_only.map_verdicts(0, frames[0]).label[0], Label::kDynamic);
  settings.revert_pixels_deg = {1.0};
  Removert with_revert(settings);
  RemovalCheck reverted(with_revert, frames);
  EXPECT_EQ(with_revert.map_verdicts(0, frames[0]).label[0], Label::kStatic);
}

TEST(Removert, KeepsADynamicVerdictThatCoarseLevelsShare) {
  std::vector<Frame> frames = edge_of_a_thing();
  frames[1].scan.points[1] *= 2;  // beside it nothing near, either
  RemovertSettings settings;
  settings.remove_pixels_deg = {0.4};
  settings.revert_pixels_deg = {1.0, 1.4};
  Removert method(settings);
  const RemovalCheck check(method, frames);
  EXPECT_EQ(method.map_verdicts(0, frames[0]).label[0], Label::kDynamic);
}

TEST(Removert, SettingsAreTold) {
  EXPECT_NE(Removert(RemovertSettings::paper()).settings().find("gate_neighbourhood_support: 60"),
            std::string::npos);
}

}  // namespace
}  // namespace stillmap
