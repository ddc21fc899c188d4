#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace stillmap {

/// The map is cut into blocks of 8 x 8 x 8 voxels.
inline constexpr int kBlockShift = 3;
inline constexpr int kBlockEdge = 1 << kBlockShift;
inline constexpr int kBlockVolume = kBlockEdge * kBlockEdge * kBlockEdge;

/// Index of a voxel in the map frame: floor(coordinate / voxel size) for each axis.
using VoxelKey = Eigen::Vector3i;
/// Index of a block: VoxelKey >> 3.
using BlockKey = Eigen::Vector3i;

/// Voxels reach to +-2^23 from the origin, so that a block key packs into 63 bits.
inline constexpr int kVoxelKeyLimit = 1 << 23;

inline VoxelKey voxel_key(const Eigen::Vector3d& point_map_m, double inverse_voxel_size) {
  return (point_map_m * inverse_voxel_size).array().floor().cast<int>();
}
inline BlockKey block_key(const VoxelKey& key) {
  return {key.x() >> kBlockShift, key.y() >> kBlockShift, key.z() >> kBlockShift};
}
/// Place of a voxel inside its block, 0 .. 511; x is fastest.
inline int place_in_block(const VoxelKey& key) {
  constexpr int mask = kBlockEdge - 1;
  return (key.x() & mask) | (key.y() & mask) << kBlockShift | (key.z() & mask) << (2 * kBlockShift);
}
inline VoxelKey voxel_key(const BlockKey& block, int place) {
  constexpr int mask = kBlockEdge - 1;
  return {block.x() * kBlockEdge + (place & mask), block.y() * kBlockEdge + (place >> kBlockShift & mask),
          block.z() * kBlockEdge + (place >> (2 * kBlockShift))};
}

/// Blocks are grouped in tiles: upright columns of 16 x 16 blocks.
inline constexpr int kTileShift = 4;
inline constexpr int kTileEdge = 1 << kTileShift;
/// Index of a tile: x and y of BlockKey >> 4.
using TileKey = Eigen::Vector2i;

inline TileKey tile_key(const BlockKey& key) {
  return {key.x() >> kTileShift, key.y() >> kTileShift};
}

/// 21 bits an axis: unique within kVoxelKeyLimit, and in a fixed order.
inline std::uint64_t packed(const BlockKey& key) {
  constexpr std::int64_t offset = 1 << 20;
  return static_cast<std::uint64_t>(key.x() + offset) << 42 |
         static_cast<std::uint64_t>(key.y() + offset) << 21 | static_cast<std::uint64_t>(key.z() + offset);
}
inline std::uint64_t packed_tile(const TileKey& key) {
  return packed(BlockKey(key.x(), key.y(), 0));
}
inline BlockKey unpacked(std::uint64_t key) {
  constexpr int offset = 1 << 20, mask = (1 << 21) - 1;
  return {static_cast<int>(key >> 42) - offset, static_cast<int>(key >> 21 & mask) - offset,
          static_cast<int>(key & mask) - offset};
}

/// Finaliser of MurmurHash3 (Appleby): neighbouring keys spread over the table.
struct BlockKeyHash {
  std::size_t operator()(std::uint64_t key) const {
    key = (key ^ key >> 33) * 0xff51afd7ed558ccdULL;
    key = (key ^ key >> 33) * 0xc4ceb9fe1a85ec53ULL;
    return key ^ key >> 33;
  }
};

}  // namespace stillmap
