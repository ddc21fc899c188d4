#include "stillmap/cell_mask.hpp"

#include <gtest/gtest.h>

#include <random>

namespace stillmap {
namespace {

constexpr int kEdge = 4, kBlocks = 3;  // cells along a block, blocks along the neighbourhood

int cell_index(int x, int y, int z) {
  return x + kEdge * y + kEdge * kEdge * z;
}

/// The cell at (x, y, z) of the 12 x 12 x 12 cells of all blocks.
bool is_set(const std::array<CellMask, 27>& blocks, int x, int y, int z) {
  const int block = x / kEdge + kBlocks * (y / kEdge) + kBlocks * kBlocks * (z / kEdge);
  return blocks[block] >> cell_index(x % kEdge, y % kEdge, z % kEdge) & 1;
}

CellMask grown_by_brute_force(const std::array<CellMask, 27>& blocks) {
  CellMask mask = 0;
  for (int z = 0; z < kEdge; ++z)
    for (int y = 0; y < kEdge; ++y)
      for (int x = 0; x < kEdge; ++x)
        for (int dz = -1; dz <= 1; ++dz)
          for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
              if (is_set(blocks, x + kEdge + dx, y + kEdge + dy, z + kEdge + dz))
                mask |= CellMask{1} << cell_index(x, y, z);
  return mask;
}

TEST(CellMask, ACellHoldsEightVoxels) {
  std::array<int, 64> voxels{};
  for (int place = 0; place < kBlockVolume; ++place) {
    const VoxelKey key = voxel_key(BlockKey::Zero(), place);
    const int cell = cell_index(key.x() / 2, key.y() / 2, key.z() / 2);
    EXPECT_EQ(cell_bit(place), CellMask{1} << cell);
    ++voxels[cell];
  }
  for (const int count : voxels) EXPECT_EQ(count, 8);
}

TEST(CellMask, GrownMatchesBruteForce) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    std::array<CellMask, 27> blocks{};
    for (CellMask& mask : blocks) {
      mask = random();
      for (int thin = 0; thin < trial % 8; ++thin) mask &= random();
    }
    EXPECT_EQ(grown(blocks), grown_by_brute_force(blocks));
  }
}

TEST(CellMask, ASingleCellOfAnyBlockGrowsRight) {
  for (int block = 0; block < 27; ++block)
    for (int cell = 0; cell < 64; ++cell) {
      std::array<CellMask, 27> blocks{};
      blocks[block] = CellMask{1} << cell;
      ASSERT_EQ(grown(blocks), grown_by_brute_force(blocks)) << "block " << block << ", cell " << cell;
    }
}

}  // namespace
}  // namespace stillmap
