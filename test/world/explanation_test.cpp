// A box stands, then leaves: asked about its place, the map must say what the simulator knows.
#include <gtest/gtest.h>

#include "simulation/path.hpp"
#include "simulation/structures.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {
namespace {

/// A box of 1 m stands 8 m ahead until 2 s, in front of a wall at 15 m.
World box_before_a_wall() {
  World world;
  world.add_ground(0, surfaces::kRoad);
  add_wall(&world, {15, -20}, {15, 20}, 0.3, 5, surfaces::kWall);
  Mover box;
  box.body = {{make_box(pose_at(0, 0, 1), {1, 1, 2}, surfaces::kMetal)}};
  const SpeedProfile leaves = SpeedProfile::starting(2, 5);
  box.motion = along(Path({{8, 0}, {8, 14}}), leaves, world.ground);
  box.first_move_s = leaves.first_move_s();
  world.add_mover(std::move(box));
  return world;
}

struct ExplanationTest : testing::Test {
  static Mapper after(int scans) {
    Mapper mapper{on_two_threads()};
    RunOptions options;
    options.scans = scans;
    run(&mapper, box_before_a_wall(), standing_at(0, 0, 1.5), options);
    return mapper;
  }
  static constexpr double kFace_m = 7.5;  // of the box, at sensor height
  const Eigen::Vector3d face{kFace_m, 0.05, 1.45}, wall{14.85, 0.05, 1.45};
};

TEST_F(ExplanationTest, WhatStandsIsSupported) {
  const Explanation told = after(15).explain(face);
  ASSERT_TRUE(told.in_map);
  EXPECT_EQ(told.label, Label::kStatic);
  EXPECT_GE(told.hits, 12);  // of 15 scans
  EXPECT_EQ(told.seen_through, 0);
  const PlaceEvidence* last = last_evidence(told);
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->kind, Evidence::kSupport);
  EXPECT_EQ(last->stamp_ns, 1'400'000'000);
  EXPECT_NEAR(last->range_m, kFace_m, 0.15);
  EXPECT_NEAR(last->difference_m(), 0, 0.15);
  EXPECT_NEAR((last->origin_map_m - Eigen::Vector3d(0, 0, 1.5)).norm(), 0, 0.1);
  EXPECT_NE(in_words(told).find("static, p_static 0.9"), std::string::npos) << in_words(told);
  EXPECT_NE(in_words(told).find("Last evidence: support, scan of 1.400 s (0.0 s before"), std::string::npos);
}

TEST_F(ExplanationTest, WhatLeftWasSeenThroughAsFarAsTheWall) {
  const Explanation told = after(40).explain(face);
  ASSERT_TRUE(told.in_map);
  EXPECT_EQ(told.label, Label::kDynamic);
  EXPECT_GE(told.seen_through, 3);
  const PlaceEvidence* last = last_evidence(told);
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->kind, Evidence::kConflict);
  EXPECT_EQ(last->stamp_ns, 3'900'000'000);
  EXPECT_NEAR(last->difference_m(), 14.85 - kFace_m, 0.2);
  EXPECT_GT(last->difference_m(), last->conflict_above_m);
  EXPECT_NE(in_words(told).find("it saw through the place"), std::string::npos) << in_words(told);
  std::cout << in_words(told) << '\n';
}

TEST_F(ExplanationTest, WhatIsHiddenIsOcclusion) {
  const PlaceEvidence* last = nullptr;
  const Explanation told = after(15).explain(wall);
  EXPECT_FALSE(told.in_map);  // the box has always stood before it
  last = last_evidence(told);
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->kind, Evidence::kOcclusion);
  EXPECT_NEAR(last->difference_m(), kFace_m - 14.85, 0.2);
  EXPECT_NE(in_words(told).find("no return ever came from there"), std::string::npos) << in_words(told);
}

TEST_F(ExplanationTest, AnEmptyMapSaysSo) {
  const Explanation told = Mapper{on_two_threads()}.explain(face);
  EXPECT_FALSE(told.in_map);
  EXPECT_EQ(last_evidence(told), nullptr);
  EXPECT_NE(in_words(told).find("None of the kept scans"), std::string::npos);
}

}  // namespace
}  // namespace stillmap::simulation
