#include "stillmap/voxel_key.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <tuple>

namespace stillmap {
namespace {

TEST(VoxelKey, IsTheFloorOnBothSidesOfZero) {
  EXPECT_EQ(voxel_key({0.75, 0.0, 0.49}, 2.0), VoxelKey(1, 0, 0));
  EXPECT_EQ(voxel_key({-0.01, -0.5, -0.51}, 2.0), VoxelKey(-1, -1, -2));
}

TEST(VoxelKey, BlockAndPlaceByHand) {
  EXPECT_EQ(block_key({7, 8, 0}), BlockKey(0, 1, 0));
  EXPECT_EQ(place_in_block({7, 8, 2}), 7 + 0 * 8 + 2 * 64);
  EXPECT_EQ(block_key({-1, -8, -9}), BlockKey(-1, -1, -2));
  EXPECT_EQ(place_in_block({-1, -8, -9}), 7 + 0 * 8 + 7 * 64);
  EXPECT_EQ(voxel_key(BlockKey(-1, 2, 0), 7 + 3 * 8 + 5 * 64), VoxelKey(-1, 19, 5));
}

TEST(VoxelKey, BlockAndPlaceGoBackToTheKey) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> anywhere(-kVoxelKeyLimit, kVoxelKeyLimit - 1);
  for (int i = 0; i < 10000; ++i) {
    const VoxelKey key(anywhere(random), anywhere(random), anywhere(random));
    EXPECT_EQ(voxel_key(block_key(key), place_in_block(key)), key);
  }
}

TEST(BlockKey, PackedByHand) {
  constexpr std::uint64_t kMiddle = std::uint64_t{1} << 20;
  EXPECT_EQ(packed({0, 0, 0}), kMiddle << 42 | kMiddle << 21 | kMiddle);
  EXPECT_EQ(packed({-1, 0, 2}), (kMiddle - 1) << 42 | kMiddle << 21 | (kMiddle + 2));
}

TEST(BlockKey, PackedIsUniqueAndKeepsTheOrder) {
  std::mt19937 random(2);
  constexpr int kLimit = kVoxelKeyLimit / kBlockEdge;
  std::uniform_int_distribution<int> anywhere(-kLimit, kLimit - 1), near(-2, 2);
  std::map<std::tuple<int, int, int>, std::uint64_t> seen;
  for (int i = 0; i < 10000; ++i) {
    const BlockKey key = i % 2 == 0 ? BlockKey(anywhere(random), anywhere(random), anywhere(random))
                                    : BlockKey(near(random), near(random), near(random));
    seen[{key.x(), key.y(), key.z()}] = packed(key);
    EXPECT_EQ(unpacked(packed(key)), key);
  }
  for (auto it = seen.begin(), next = std::next(it); next != seen.end(); ++it, ++next)
    EXPECT_LT(it->second, next->second);
}

}  // namespace
}  // namespace stillmap
