#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "scan_view.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// Where a row of the scan lies in the map.
struct VoxelRef {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::uint32_t block = kNone;
  std::uint16_t place = 0;  ///< in the block
  std::uint16_t rank = 0;   ///< of the voxel among the block's stored ones, in the present scan
  bool exists() const { return block != kNone; }
};

/// The last scan that hit a block, and the block's number among all that it hit.
struct LastHit {
  std::uint32_t scan = 0, hit = 0;
};

/// A block that this scan hit. Its rows are rows_by_block[first_row + 0 .. row_count - 1]; those that made a
/// voxel are new_rows[first_row + 0 .. new_count - 1].
struct HitBlock {
  VoxelBlock* block;
  std::uint32_t index;  ///< of the block in the map
  std::uint32_t first_row = 0, row_count = 0, new_count = 0;
};

/// A scan that has its labels.
struct LabelledScan {
  ScanView view;
  Eigen::Isometry3d T_map_sensor;
};

}  // namespace stillmap
