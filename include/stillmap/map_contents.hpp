#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "stillmap/cell_mask.hpp"
#include "stillmap/decision.hpp"
#include "stillmap/map_snapshot.hpp"
#include "stillmap/voxel.hpp"
#include "stillmap/voxel_key.hpp"

namespace stillmap {

/// Everything that outlives the present scan in one block of 8 x 8 x 8 voxels.
struct BlockContents {
  BlockKey key = BlockKey::Zero();  ///< in blocks from the origin of the map frame
  CellMask porous = 0;              ///< cells with surface that was hit again after it was seen through
  std::array<std::uint64_t, kBlockVolume / 64> occupied{};  ///< bit `place`: that voxel was hit
  std::vector<Voxel> voxels;  ///< one for each bit, by ascending place; idle and age as of the newest scan
};

/// The complete state of a map, apart from the layout in memory: what a .stillmap file holds.
struct MapContents {
  std::int64_t stamp_ns = 0;  ///< of the newest scan in it
  double voxel_size_m = 0;
  std::vector<BlockContents> blocks;  ///< no key twice
};

/// Calls visit(place, voxel) for each voxel of the block, by ascending place.
template <class BlockT, class Visitor>
void for_each_voxel(BlockT& block, Visitor&& visit) {
  auto* voxel = block.voxels.data();
  for (int word = 0; word < static_cast<int>(block.occupied.size()); ++word)
    for (std::uint64_t bits = block.occupied[word]; bits != 0; bits &= bits - 1)
      visit(word * 64 + __builtin_ctzll(bits), *voxel++);
}

/// What breaks the rules of BlockContents, in words; empty when nothing does.
const char* problem(const BlockContents& block);

/// The block `scans` scans after it was as given.
BlockContents aged(BlockContents block, std::uint32_t scans);

/// Appends the voxels of a block of the snapshot's voxel size.
void append(MapSnapshot& snapshot, const BlockContents& block, const Decision& decision);

/// A map that is given piece by piece, so that it never need be in memory as a whole.
struct MapPieces {
  std::int64_t stamp_ns = 0;  ///< of the newest scan in it
  double voxel_size_m = 0;
  std::function<bool(std::vector<BlockContents>&)> next;  ///< appends some blocks; false = there are no more
};
/// The contents as one piece; they must live as long.
MapPieces pieces_of(const MapContents& map);
/// All pieces as one.
MapContents contents_of(const MapPieces& map);

/// The voxels' places, log-odds and labels, in the pieces' order.
MapSnapshot snapshot_of(const MapPieces& map, const Decision& decision);

}  // namespace stillmap
