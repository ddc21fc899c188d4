// Repair by hand in a simulated yard: what is in the box changes, and nothing else.
#include <gtest/gtest.h>

#include <limits>

#include "simulation/structures.hpp"
#include "support/expect_error.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {
namespace {

struct MapRepairTest : testing::Test {
  Mapper mapper{on_two_threads()};
  const Eigen::AlignedBox3d post = box({5.5, -0.5, 0.3}, {6.5, 0.5, 3});

  MapRepairTest() {
    World world;
    world.add_ground(0, surfaces::kRoad);
    add_wall(&world, {15, -20}, {15, 20}, 0.3, 5, surfaces::kWall);
    world.add_box(pose_at(6, 0, 1), {0.5, 0.5, 2}, surfaces::kMetal);
    RunOptions options;
    options.scans = 12;
    run(&mapper, world, standing_at(0, 0, 1.5), options);
  }
  std::size_t outside(const MapSnapshot& map) const {
    std::size_t count = 0;
    for (const SnapshotVoxel& voxel : map.voxels) count += !post.contains(voxel.center.cast<double>());
    return count;
  }
};

TEST_F(MapRepairTest, AClearedBoxIsForgottenAndComesBackWhenItIsSeenAgain) {
  const MapSnapshotPtr before = mapper.snapshot();
  const std::size_t cleared = mapper.clear_box(post);
  EXPECT_GT(cleared, 50U);
  const MapSnapshotPtr after = mapper.snapshot();
  EXPECT_EQ(after->voxels.size() + cleared, before->voxels.size());
  EXPECT_EQ(percent_of_voxels(mapper, post, Label::kStatic), -1);  // none at all
  EXPECT_EQ(outside(*after), outside(*before));
  EXPECT_EQ(mapper.clear_box(post), 0U);

  World world;
  world.add_box(pose_at(6, 0, 1), {0.5, 0.5, 2}, surfaces::kMetal);
  RunOptions options;
  options.scans = 5;
  run(&mapper, world, standing_at(0, 0, 1.5), options);
  EXPECT_GT(percent_of_voxels(mapper, post, Label::kStatic), 90);
}

TEST_F(MapRepairTest, ARelabelledBoxHasTheLabel) {
  EXPECT_GT(percent_of_voxels(mapper, post, Label::kStatic), 90);
  for (const Label label : {Label::kDynamic, Label::kUncertain, Label::kStatic}) {
    const std::size_t voxels = mapper.voxel_count();
    EXPECT_GT(mapper.relabel_box(post, label), 50U);
    EXPECT_EQ(percent_of_voxels(mapper, post, label), 100);
    EXPECT_EQ(mapper.voxel_count(), voxels);
  }
}

TEST_F(MapRepairTest, RefusesWhatIsNoBoxOrNoLabelOfAVoxel) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Eigen::AlignedBox3d& bad : {box({1, 1, 1}, {0, 2, 2}), box({nan, 0, 0}, {1, 1, 1})})
    expect_error<std::invalid_argument>([&] { mapper.clear_box(bad); }, {"box", "min", "max"});
  expect_error<std::invalid_argument>([&] { mapper.relabel_box(post, Label::kInvalid); }, {"static"});
  EXPECT_EQ(mapper.clear_box(box({900, 0, 0}, {901, 1, 1})), 0U);
}

}  // namespace
}  // namespace stillmap::simulation
