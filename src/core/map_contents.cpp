#include "stillmap/map_contents.hpp"

#include <algorithm>

#include "stillmap/log_odds.hpp"

namespace stillmap {

const char* problem(const BlockContents& block) {
  constexpr int kBlockKeyLimit = kVoxelKeyLimit / kBlockEdge;
  for (const int index : {block.key.x(), block.key.y(), block.key.z()})
    if (index < -kBlockKeyLimit || index >= kBlockKeyLimit) return "a block lies outside of the map's limits";
  std::size_t occupied = 0;
  for (const std::uint64_t word : block.occupied)
    occupied += static_cast<std::size_t>(__builtin_popcountll(word));
  return occupied == block.voxels.size() ? "" : "a block's voxels do not match their places";
}

BlockContents aged(BlockContents block, std::uint32_t scans) {
  for (Voxel& voxel : block.voxels) voxel.grow_older(scans);
  return block;
}

void append(MapSnapshot& snapshot, const BlockContents& block, const Decision& decision) {
  for_each_voxel(block, [&](int place, const Voxel& voxel) {
    const Eigen::Vector3d center =
        (voxel_key(block.key, place).cast<double>().array() + 0.5) * snapshot.voxel_size_m;
    const float log_odds = voxel.log_odds();
    snapshot.voxels.push_back({center.cast<float>(), log_odds, decision(p_from_log_odds(log_odds))});
  });
}

MapPieces pieces_of(const MapContents& map) {
  return {map.stamp_ns, map.voxel_size_m, [&map, given = false](std::vector<BlockContents>& blocks) mutable {
            if (given) return false;
            blocks.insert(blocks.end(), map.blocks.begin(), map.blocks.end());
            return given = true;
          }};
}

MapContents contents_of(const MapPieces& map) {
  MapContents contents{map.stamp_ns, map.voxel_size_m, {}};
  while (map.next(contents.blocks)) {
  }
  return contents;
}

MapSnapshot snapshot_of(const MapPieces& map, const Decision& decision) {
  MapSnapshot snapshot{map.stamp_ns, map.voxel_size_m, {}};
  for (std::vector<BlockContents> blocks; map.next(blocks); blocks.clear())
    for (const BlockContents& block : blocks) append(snapshot, block, decision);
  return snapshot;
}

}  // namespace stillmap
