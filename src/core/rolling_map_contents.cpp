// What is in a RollingMap, wherever its tiles are.
#include <algorithm>

#include "rolling_map.hpp"
#include "tile_packing.hpp"

namespace stillmap {

std::vector<TileKey> RollingMap::tiles() const {
  std::vector<TileKey> keys;
  for (const auto& [packed_key, tile] : open_) keys.push_back(tile.key);
  for (const auto& [packed_key, tile] : packed_) keys.push_back(tile.key);
  std::sort(keys.begin(), keys.end(),
            [](const TileKey& a, const TileKey& b) { return packed_tile(a) < packed_tile(b); });
  return keys;
}

std::vector<BlockContents> RollingMap::contents(const TileKey& key, std::uint32_t scan) const {
  std::vector<BlockContents> blocks;
  if (const BlockTile* const entries = map_.tile(key)) {
    for (const BlockEntry& entry : *entries) blocks.push_back(map_.block(entry.index).contents(scan));
    return blocks;
  }
  const auto it = packed_.find(packed_tile(key));
  if (it == packed_.end()) return blocks;
  for (BlockContents& block : unpack(it->second.bytes))
    blocks.push_back(aged(std::move(block), scan - it->second.scan));
  return blocks;
}

std::vector<BlockContents> RollingMap::contents_anywhere(const TileKey& key, std::uint32_t scan) const {
  std::vector<BlockContents> blocks = contents(key, scan);
  if (!blocks.empty() || store_ == nullptr) return blocks;
  Tile far = store_->get(key);
  for (BlockContents& block : far.blocks) blocks.push_back(aged(std::move(block), scan - far.scan));
  return blocks;
}

std::vector<TileKey> RollingMap::tiles_anywhere() const {
  std::vector<TileKey> keys = tiles();
  if (store_ == nullptr) return keys;
  for (const TileKey& key : store_->keys())
    if (!is_open(key) && packed_.count(packed_tile(key)) == 0) keys.push_back(key);
  return keys;
}

void RollingMap::edit(const Eigen::AlignedBox3d& box_map_m, std::uint32_t scan,
                      const std::function<bool(BlockContents&)>& change) {
  const double tile_m = map_.block_size_m() * kTileEdge;
  for (const TileKey& key : tiles_anywhere()) {
    const Eigen::Array2d corner = key.cast<double>().array() * tile_m;
    if ((corner > box_map_m.max().head<2>().array()).any() ||
        (corner + tile_m < box_map_m.min().head<2>().array()).any())
      continue;
    std::vector<BlockContents> blocks = contents_anywhere(key, scan), changed;
    for (BlockContents& block : blocks)
      if (change(block)) changed.push_back(block);
    if (changed.empty()) continue;
    if (is_open(key)) {
      for (const BlockContents& block : changed) map_.restore(block, scan);
    } else if (packed_.count(packed_tile(key)) != 0) {
      take(key);
      pack_tile(key, {scan, std::move(blocks)});
    } else {
      store_->put(key, {scan, std::move(blocks)});
    }
  }
}

void RollingMap::adopt_map() {
  open_.clear();
  packed_.clear();
  packed_voxels_ = 0;
  if (store_ != nullptr) store_->clear();
  for (std::uint32_t index = 0; index < map_.block_count(); ++index) {
    const TileKey key = tile_key(map_.block(index).key());
    open_.try_emplace(packed_tile(key), OpenTile{key, moves_});
  }
}

void RollingMap::import(const std::vector<BlockContents>& blocks, std::uint32_t scan) {
  tsl::robin_map<std::uint64_t, Tile, BlockKeyHash> closed;  // those that are not open
  for (const BlockContents& block : blocks) {
    const TileKey key = tile_key(block.key);
    if (is_open(key)) {
      map_.restore(block, scan);
    } else {
      closed[packed_tile(key)].blocks.push_back(block);
    }
  }
  for (auto it = closed.begin(); it != closed.end(); ++it) {
    Tile& tile = it.value();
    const TileKey key = tile_key(tile.blocks.front().key);
    // What is already there goes on with the new blocks, through a small map of its own.
    VoxelMap merged(map_.voxel_size_m());
    const Tile before = take(key);
    for (const BlockContents& block : before.blocks) merged.restore(block, before.scan);
    for (const BlockContents& block : tile.blocks) merged.restore(block, scan);
    tile = {scan, {}};
    for (std::uint32_t index = 0; index < merged.block_count(); ++index)
      tile.blocks.push_back(merged.block(index).contents(scan));
    pack_tile(key, tile);
  }
}

}  // namespace stillmap
