#include "io/whole_map.hpp"

#include <tsl/robin_set.h>

#include <iterator>

namespace stillmap {
namespace {

/// Those in memory, then the others.
std::vector<TileKey> all_tiles(const Mapper& mapper, const TileStore* far_tiles) {
  std::vector<TileKey> keys = mapper.tiles();
  if (far_tiles == nullptr) return keys;
  tsl::robin_set<std::uint64_t, BlockKeyHash> known;
  for (const TileKey& key : keys) known.insert(packed_tile(key));
  for (const TileKey& key : far_tiles->keys())
    if (known.insert(packed_tile(key)).second) keys.push_back(key);
  return keys;
}

}  // namespace

MapPieces whole_map(const Mapper& mapper, TileStore* far_tiles, std::mutex& mutex) {
  const std::lock_guard lock(mutex);
  auto next = [&mapper, far_tiles, &mutex, keys = all_tiles(mapper, far_tiles),
               at = std::size_t{0}](std::vector<BlockContents>& blocks) mutable {
    if (at == keys.size()) return false;
    const TileKey key = keys[at++];
    std::unique_lock tile_lock(mutex);
    std::vector<BlockContents> tile = mapper.export_tile(key);
    const auto scan = static_cast<std::uint32_t>(mapper.scan_count());
    tile_lock.unlock();
    if (tile.empty() && far_tiles != nullptr) {
      Tile far = far_tiles->get(key);
      for (BlockContents& block : far.blocks) tile.push_back(aged(std::move(block), scan - far.scan));
    }
    std::move(tile.begin(), tile.end(), std::back_inserter(blocks));
    return true;
  };
  return {mapper.stamp_ns(), mapper.parameters().voxel_size_m, std::move(next)};
}

}  // namespace stillmap
