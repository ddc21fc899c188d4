#pragma once

#include <array>
#include <cstdint>

#include "stillmap/voxel_key.hpp"

namespace stillmap {

/// One bit for each cell of 2 x 2 x 2 voxels of a block: 4 x 4 x 4 cells, x fastest.
using CellMask = std::uint64_t;

namespace cell_mask {

constexpr std::array<std::uint8_t, kBlockVolume> cells() {
  std::array<std::uint8_t, kBlockVolume> cells{};
  for (int place = 0; place < kBlockVolume; ++place) {
    const int x = place & (kBlockEdge - 1), y = place >> kBlockShift & (kBlockEdge - 1);
    const int z = place >> (2 * kBlockShift);
    cells[place] = static_cast<std::uint8_t>(x / 2 | y / 2 << 2 | z / 2 << 4);
  }
  return cells;
}
inline constexpr std::array<std::uint8_t, kBlockVolume> kCells = cells();

}  // namespace cell_mask

/// The cell of a voxel, where it is `set`; else none.
inline CellMask cell_bit(int place, bool set = true) {
  return CellMask{set} << cell_mask::kCells[place];
}

namespace cell_mask {

constexpr CellMask kFirstX = 0x1111111111111111ULL, kFirstY = 0x000F000F000F000FULL, kFirstZ = 0xFFFFULL;

/// Cells that are set, or whose neighbour along one axis is. `stride` is 1, 4 or 16 bits; `low` and `high`
/// are the blocks before and after along that axis.
inline CellMask grown_along(CellMask low, CellMask here, CellMask high, int stride, CellMask first_layer) {
  const CellMask last_layer = first_layer << (3 * stride);
  return here | (here << stride & ~first_layer) | (here >> stride & ~last_layer) |
         (low >> (3 * stride) & first_layer) | (high << (3 * stride) & last_layer);
}

/// The cells of a block that touch its neighbour one step before (-1) or after (1) along an axis; all for 0.
inline CellMask facing(int step, CellMask first_layer, int stride) {
  return step < 0 ? first_layer : step > 0 ? first_layer << (3 * stride) : ~CellMask{0};
}

}  // namespace cell_mask

/// The cells of a block that touch its neighbour, which lies -1, 0 or 1 blocks away along each axis.
inline CellMask facing(int x, int y, int z) {
  using namespace cell_mask;
  return facing(x, kFirstX, 1) & facing(y, kFirstY, 4) & facing(z, kFirstZ, 16);
}

/// The cells of the middle block that are set, or touch a set cell of the 3 x 3 x 3 blocks (x fastest): every
/// voxel within two voxels of a set cell's voxel is covered.
inline CellMask grown(const std::array<CellMask, 27>& blocks) {
  using namespace cell_mask;
  std::array<CellMask, 9> along_x;
  for (int i = 0; i < 9; ++i)
    along_x[i] = grown_along(blocks[3 * i], blocks[3 * i + 1], blocks[3 * i + 2], 1, kFirstX);
  std::array<CellMask, 3> along_y;
  for (int i = 0; i < 3; ++i)
    along_y[i] = grown_along(along_x[3 * i], along_x[3 * i + 1], along_x[3 * i + 2], 4, kFirstY);
  return grown_along(along_y[0], along_y[1], along_y[2], 16, kFirstZ);
}

}  // namespace stillmap
