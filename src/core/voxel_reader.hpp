#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "rolling_map.hpp"

namespace stillmap {

/// Finds voxels as of `scan` wherever their tile is. One that is not open is read once and kept for the
/// reader's life, which must end before the map changes.
class VoxelReader {
 public:
  VoxelReader(const RollingMap& rolling, std::uint32_t scan) : rolling_(rolling), scan_(scan) {}
  std::uint32_t scan() const { return scan_; }

  std::optional<Voxel> find(const VoxelKey& key) {
    const BlockKey block = block_key(key);
    const VoxelMap& map = map_with(tile_key(block));
    const std::int64_t index = map.find_block(block);
    const int place = place_in_block(key);
    if (index < 0 || !map.block(static_cast<std::uint32_t>(index)).contains(place)) return std::nullopt;
    return map.block(static_cast<std::uint32_t>(index)).as_of(place, scan_);
  }

 private:
  const VoxelMap& map_with(const TileKey& tile) {
    if (rolling_.is_open(tile)) return rolling_.open_map();
    const auto [it, is_new] = closed_.try_emplace(packed_tile(tile), rolling_.open_map().voxel_size_m());
    if (is_new)
      for (const BlockContents& block : rolling_.contents_anywhere(tile, scan_))
        it->second.restore(block, scan_);
    return it->second;
  }

  const RollingMap& rolling_;
  std::uint32_t scan_;
  std::map<std::uint64_t, VoxelMap> closed_;
};

}  // namespace stillmap
