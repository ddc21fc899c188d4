// Two sessions in one yard: log-odds add up where both were, and all that only one saw is there.
#include "maps/map_merge.hpp"

#include <gtest/gtest.h>

#include "maps/map_index.hpp"
#include "maps/two_sessions.hpp"
#include "support/expect_error.hpp"

namespace stillmap::simulation {
namespace {

constexpr LogOddsBounds kBounds{-4, 4};

std::size_t voxels_of(const MapContents& map) {
  std::size_t voxels = 0;
  for (const BlockContents& block : map.blocks) voxels += block.voxels.size();
  return voxels;
}

TEST(MapMerge, LogOddsAddUpAndNothingIsLost) {
  const MapContents a = session({{4, -4}}), b = session({{7, 2}});
  MapContents merged = a;
  merge(merged, b, kBounds);
  const MapIndex of_a(a), of_b(b);
  std::size_t in_both = 0, checked = 0;
  for (const BlockContents& block : merged.blocks) {
    ASSERT_STREQ(problem(block), "");
    for_each_voxel(block, [&](int place, const Voxel& voxel) {
      const VoxelKey key = voxel_key(block.key, place);
      const Voxel *va = of_a.voxel(key), *vb = of_b.voxel(key);
      ASSERT_TRUE(va != nullptr || vb != nullptr);
      ++checked;
      in_both += va != nullptr && vb != nullptr;
      const float expected = (va != nullptr ? va->log_odds() : 0) + (vb != nullptr ? vb->log_odds() : 0);
      EXPECT_NEAR(voxel.log_odds(), std::clamp(expected, kBounds.min, kBounds.max), 1e-3);
    });
  }
  EXPECT_EQ(checked, voxels_of(a) + voxels_of(b) - in_both);
  EXPECT_GT(in_both, 5000U);
}

TEST(MapMerge, DoesNotDependOnTheOrder) {
  const MapContents a = session({{4, -4}}), b = session({{7, 2}});
  MapContents ab = a, ba = b;
  merge(ab, b, kBounds);
  merge(ba, a, kBounds);
  ASSERT_EQ(voxels_of(ab), voxels_of(ba));
  const MapIndex of_ba(ba);
  for (const BlockContents& block : ab.blocks)
    for_each_voxel(block, [&](int place, const Voxel& voxel) {
      const Voxel* other = of_ba.voxel(voxel_key(block.key, place));
      ASSERT_NE(other, nullptr);
      EXPECT_EQ(voxel.log_odds_fixed, other->log_odds_fixed);
      EXPECT_EQ(voxel.hits, other->hits);
    });
}

TEST(MapMerge, RefusesAnotherResolutionAndKeepsTheMap) {
  MapContents map = session({});
  const std::size_t voxels = voxels_of(map);
  expect_error<std::invalid_argument>([&] { merge(map, session({}, 0.2), kBounds); }, {"0.1", "0.2"});
  EXPECT_EQ(voxels_of(map), voxels);
}

}  // namespace
}  // namespace stillmap::simulation
