#pragma once

#include <tsl/robin_map.h>

#include <cstdint>

#include "stillmap/map_contents.hpp"

namespace stillmap {

/// Finds the voxels of a map, which must outlive it unchanged.
class MapIndex {
 public:
  explicit MapIndex(const MapContents& map) : map_(map) {
    for (std::size_t i = 0; i < map.blocks.size(); ++i) index_.emplace(packed(map.blocks[i].key), i);
  }

  /// nullptr where the map has no such block.
  const BlockContents* block(const BlockKey& key) const {
    const auto it = index_.find(packed(key));
    return it == index_.end() ? nullptr : &map_.blocks[it->second];
  }
  /// nullptr where no voxel was hit.
  const Voxel* voxel(const VoxelKey& key) const {
    const BlockContents* found = block(block_key(key));
    const int place = place_in_block(key), word = place >> 6;
    if (found == nullptr || (found->occupied[word] >> (place & 63) & 1) == 0) return nullptr;
    std::size_t rank = __builtin_popcountll(found->occupied[word] & ((std::uint64_t{1} << (place & 63)) - 1));
    for (int before = 0; before < word; ++before) rank += __builtin_popcountll(found->occupied[before]);
    return &found->voxels[rank];
  }

 private:
  const MapContents& map_;
  tsl::robin_map<std::uint64_t, std::size_t, BlockKeyHash> index_;
};

}  // namespace stillmap
