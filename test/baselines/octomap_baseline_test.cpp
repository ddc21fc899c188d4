#include "baselines/octomap_baseline.hpp"

#include <gtest/gtest.h>

#include "removal_check.hpp"

namespace stillmap {
namespace {

const Eigen::Vector3d kOrigin(0, 0, 1.7), kCarLow(6, -1, 0.3), kCarHigh(10, 1, 1.5), kWallLow(15, -8, 0),
    kWallHigh(16, 8, 3);

/// A car stands before a wall in the first scans, then is gone.
std::vector<Frame> car_leaves(int with_car, int without) {
  SmallWorld full, empty;
  full.add_box(kWallLow, kWallHigh);
  empty = full;
  full.add_box(kCarLow, kCarHigh);
  std::vector<Frame> frames(static_cast<std::size_t>(with_car), full.scan(kOrigin));
  frames.insert(frames.end(), static_cast<std::size_t>(without), empty.scan(kOrigin));
  return frames;
}

OctomapSettings coarse() {
  OctomapSettings settings;
  settings.voxel_size_m = 0.2;
  return settings;
}

TEST(OctomapBaseline, RaysClearWhatIsGone) {
  const std::vector<Frame> frames = car_leaves(1, 6);
  OctomapBaseline method(coarse());
  const RemovalCheck check(method, frames);
  EXPECT_GT(check.removed_share(kCarLow, kCarHigh), 0.9);
  EXPECT_LT(check.removed_share(kWallLow, kWallHigh), 0.02);
}

TEST(OctomapBaseline, HitsOutweighMisses) {  // log-odds +0.85 a hit, -0.41 a miss
  const std::vector<Frame> frames = car_leaves(3, 3);
  OctomapBaseline method(coarse());
  EXPECT_LT(RemovalCheck(method, frames).removed_share(kCarLow, kCarHigh), 0.1);
}

TEST(OctomapBaseline, VoxelSupportProtects) {
  const std::vector<Frame> frames = car_leaves(4, 40);
  OctomapSettings settings = coarse();
  OctomapBaseline without_gate(settings);
  EXPECT_GT(RemovalCheck(without_gate, frames).removed_share(kCarLow, kCarHigh), 0.9);
  settings.gates.voxel_support = 4;
  OctomapBaseline with_gate(settings);
  EXPECT_LT(RemovalCheck(with_gate, frames).removed_share(kCarLow, kCarHigh), 0.01);
}

TEST(OctomapBaseline, RowsWithoutReturnAreInvalid) {
  Frame frame;
  frame.scan.points = {Eigen::Vector3f::Zero(), Eigen::Vector3f::Constant(std::nanf("")), {1, 0, 0}};
  OctomapBaseline method(coarse());
  EXPECT_FALSE(method.add(frame));
  method.finish();
  const PointVerdicts verdicts = method.map_verdicts(0, frame);
  EXPECT_EQ(verdicts.label, (std::vector<Label>{Label::kInvalid, Label::kInvalid, Label::kStatic}));
}

TEST(OctomapBaseline, SettingsAreTold) {
  EXPECT_NE(OctomapBaseline(OctomapSettings::paper()).settings().find("gate_voxel_support: 4"),
            std::string::npos);
  EXPECT_NE(OctomapBaseline(OctomapSettings::published()).settings().find("p_hit: 0.7"), std::string::npos);
}

}  // namespace
}  // namespace stillmap
