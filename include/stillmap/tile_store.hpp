#pragma once

#include <cstdint>
#include <vector>

#include "stillmap/map_contents.hpp"
#include "stillmap/voxel_key.hpp"

namespace stillmap {

/// The blocks of one tile, as of the time of a scan.
struct Tile {
  std::uint32_t scan = 0;
  std::vector<BlockContents> blocks;
};

/// Where a Mapper puts the tiles that are farther than rolling_radius_m, and finds them when it returns. Any
/// thread may call any function: a map is saved beside the running mapper. Nothing throws: a tile that
/// cannot be kept is lost, and the store says so.
class TileStore {
 public:
  virtual ~TileStore() = default;
  virtual void put(const TileKey& key, Tile tile) = 0;  ///< replaces what was there
  virtual Tile get(const TileKey& key) = 0;             ///< no blocks when there is none; it stays there
  virtual std::vector<TileKey> keys() const = 0;
  virtual void clear() = 0;
};

}  // namespace stillmap
