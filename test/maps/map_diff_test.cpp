// Between two simulated sessions one crate was put down and another taken away.
#include "maps/map_diff.hpp"

#include <gtest/gtest.h>

#include "maps/change_list.hpp"
#include "maps/two_sessions.hpp"
#include "support/expect_error.hpp"

namespace stillmap::simulation {
namespace {

const Decision kDecision = decision_of(Parameters());
const Eigen::Vector2d kTaken(4, -4), kStays(-2, 5), kPutDown(7, 2);

void expect_crate(const std::vector<Change>& changes, const Eigen::Vector2d& at) {
  ASSERT_EQ(changes.size(), 1U);
  const Eigen::AlignedBox3d& extent = changes.front().extent_m;
  const Eigen::AlignedBox3d crate(Eigen::Vector3d(at.x() - 0.5, at.y() - 0.5, 0),
                                  Eigen::Vector3d(at.x() + 0.5, at.y() + 0.5, 1));
  EXPECT_TRUE(extent.intersects(crate));
  EXPECT_LT((extent.center() - crate.center()).norm(), 0.6);
  EXPECT_LT(extent.sizes().maxCoeff(), 1.4);
  EXPECT_GT(extent.sizes().maxCoeff(), 0.7);
}

TEST(MapDiff, FindsWhatAppearedAndWhatWent) {
  const MapContents before = session({kTaken, kStays}), now = session({kStays, kPutDown});
  const MapDiff found = diff(before, now, kDecision, DiffOptions());
  std::cout << table_of(found);
  expect_crate(found.appeared, kPutDown);
  expect_crate(found.gone, kTaken);
  EXPECT_GT(found.same.size(), 10000U);

  const MapDiff back = diff(now, before, kDecision, DiffOptions());
  expect_crate(back.appeared, kTaken);
  expect_crate(back.gone, kPutDown);
}

TEST(MapDiff, TheSameSessionHasNoChanges) {
  const MapContents map = session({kStays});
  const MapDiff found = diff(map, map, kDecision, DiffOptions());
  EXPECT_TRUE(found.appeared.empty() && found.gone.empty());
  EXPECT_EQ(found.only_first + found.only_second, 0U);
}

TEST(MapDiff, WhereOneMapHasNothingAroundItCannotTell) {
  const MapContents map = session({kStays});
  MapContents half = map;
  half.blocks.clear();
  for (const BlockContents& block : map.blocks)
    if (block.key.x() < 0) half.blocks.push_back(block);
  const MapDiff found = diff(half, map, kDecision, DiffOptions());
  EXPECT_TRUE(found.gone.empty());
  EXPECT_GT(found.only_second, 2000U);
  EXPECT_EQ(found.only_first, 0U);
}

TEST(MapDiff, RefusesMapsOfDifferentResolution) {
  expect_error<std::invalid_argument>([] { diff(session({}), session({}, 0.2), kDecision, DiffOptions()); },
                                      {"0.1", "0.2", "voxel_size_m"});
}

}  // namespace
}  // namespace stillmap::simulation
