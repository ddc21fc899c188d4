#pragma once

#include <mutex>

#include "stillmap/mapper.hpp"

namespace stillmap {

/// The map of a mapper, near and far, tile by tile. `mutex` guards the mapper and is held for one tile at a
/// time, so that scans go on meanwhile: a tile is as it was when its turn came. All must live as long.
MapPieces whole_map(const Mapper& mapper, TileStore* far_tiles, std::mutex& mutex);

}  // namespace stillmap
