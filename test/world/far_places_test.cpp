// What lies so far behind the sensor that its tiles are closed away is asked about and repaired like the
// rest.
#include <gtest/gtest.h>

#include "simulation/structures.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {
namespace {

constexpr double kPost_m = 6;  ///< on the way, 3 m aside

Parameters short_sighted() {
  Parameters parameters = on_two_threads();
  parameters.max_range_m = 20;
  return parameters;
}

/// 80 m along a wall, away from a post.
struct FarPlacesTest : testing::Test {
  static Mapper driven() {
    World world;
    world.add_ground(0, surfaces::kRoad);
    add_wall(&world, {-20, -6}, {120, -6}, 0.3, 5, surfaces::kWall);
    world.add_box(pose_at(kPost_m, 3, 1), {0.5, 0.5, 2}, surfaces::kMetal);
    Mapper mapper{short_sighted()};
    RunOptions options;
    options.scans = 80;
    run(&mapper, world, driving(10, 1.5), options);
    return mapper;
  }
  static const Mapper& far() {
    static const Mapper mapper = driven();
    return mapper;
  }
  const Eigen::AlignedBox3d post = box({kPost_m - 0.5, 2.5, 0.3}, {kPost_m + 0.5, 3.5, 3});
  const Eigen::Vector3d face{kPost_m, 2.75, 1.4};
};

TEST_F(FarPlacesTest, AFarPlaceIsExplained) {
  const Explanation told = far().explain(face);
  ASSERT_TRUE(told.in_map);
  EXPECT_EQ(told.label, Label::kStatic);
  EXPECT_GE(told.hits, 3);
}

TEST_F(FarPlacesTest, APlaceOfALoadedMapIsExplainedBeforeTheFirstScan) {
  Mapper next{short_sighted()};
  next.load_map(far().export_map());
  const Explanation told = next.explain(face), before = far().explain(face);
  ASSERT_TRUE(told.in_map);
  EXPECT_EQ(told.log_odds, before.log_odds);
  EXPECT_EQ(told.hits, before.hits);
  EXPECT_TRUE(told.evidence.empty());
}

TEST_F(FarPlacesTest, AFarBoxIsRelabelledAndCleared) {
  Mapper mapper = driven();
  const std::size_t voxels = mapper.voxel_count(), relabelled = mapper.relabel_box(post, Label::kDynamic);
  EXPECT_GT(relabelled, 50U);
  EXPECT_EQ(percent_of_voxels(mapper, post, Label::kDynamic), 100);
  EXPECT_EQ(mapper.explain(face).label, Label::kDynamic);
  EXPECT_EQ(mapper.voxel_count(), voxels);
  EXPECT_EQ(mapper.clear_box(post), relabelled);
  EXPECT_EQ(percent_of_voxels(mapper, post, Label::kDynamic), -1);  // none at all
  EXPECT_FALSE(mapper.explain(face).in_map);
  EXPECT_EQ(mapper.voxel_count(), voxels - relabelled);
}

}  // namespace
}  // namespace stillmap::simulation
