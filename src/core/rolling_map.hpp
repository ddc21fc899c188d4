#pragma once

#include <tsl/robin_map.h>

#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <vector>

#include "stillmap/tile_store.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// Keeps in the VoxelMap what a scan can touch, and the tiles beyond it out of the way: packed in memory, and
/// farther than a radius in a TileStore. Nothing is lost on the way: labels do not depend on it.
class RollingMap {
 public:
  /// Open are the tiles within `open_m` of the sensor, packed the others within `memory_m` (0 = all).
  RollingMap(VoxelMap& map, double open_m, double memory_m)
      : map_(map), open_m_(open_m), memory_m_(memory_m) {}

  /// Not owned; nullptr = what is farther than memory_m is forgotten.
  void set_store(TileStore* store) { store_ = store; }
  TileStore* store() const { return store_; }

  /// Before a scan from there: afterwards the VoxelMap holds all that was ever seen within open_m.
  void move_to(const Eigen::Vector3d& origin_map_m);
  /// After `scan` from there: tiles that were left long ago are put out of the way.
  void leave(const Eigen::Vector3d& origin_map_m, std::uint32_t scan);

  std::vector<TileKey> tiles() const;  ///< those in memory, in a fixed order
  /// A tile in memory as of `scan`; empty when it is not there.
  std::vector<BlockContents> contents(const TileKey& key, std::uint32_t scan) const;
  /// Puts blocks in, over those of the same keys.
  void import(const std::vector<BlockContents>& blocks, std::uint32_t scan);
  /// A tile as of `scan`, wherever it is: in memory or in the store.
  std::vector<BlockContents> contents_anywhere(const TileKey& key, std::uint32_t scan) const;
  /// Calls change(block) for the blocks of all tiles that the box touches seen from above, one tile at a time
  /// wherever it is. Blocks for which it says true are kept as it left them.
  void edit(const Eigen::AlignedBox3d& box_map_m, std::uint32_t scan,
            const std::function<bool(BlockContents&)>& change);
  /// After the VoxelMap was made anew of all there is: nothing else counts any more.
  void adopt_map();
  const VoxelMap& open_map() const { return map_; }
  bool is_open(const TileKey& key) const { return open_.count(packed_tile(key)) != 0; }
  std::size_t voxel_count() const { return map_.voxel_count() + packed_voxels_; }  ///< in memory

 private:
  struct OpenTile {
    TileKey key = TileKey::Zero();
    std::uint32_t near_move = 0;  ///< last move that was near enough
  };
  struct PackedTile {
    TileKey key = TileKey::Zero();
    std::uint32_t scan = 0;
    std::uint32_t voxels = 0;
    std::string bytes;
  };

  std::vector<TileKey> tiles_anywhere() const;
  double distance_m(const TileKey& key, const Eigen::Vector3d& origin_map_m) const;
  void open(const TileKey& key);
  void close_left(std::uint32_t scan);
  void move_away(const Eigen::Vector3d& origin_map_m);
  void pack_tile(const TileKey& key, const Tile& tile);
  Tile take(const TileKey& key);

  VoxelMap& map_;
  double open_m_, memory_m_;
  TileStore* store_ = nullptr;
  std::uint32_t moves_ = 0;
  tsl::robin_map<std::uint64_t, OpenTile, BlockKeyHash> open_;
  tsl::robin_map<std::uint64_t, PackedTile, BlockKeyHash> packed_;
  std::size_t packed_voxels_ = 0;
};

}  // namespace stillmap
