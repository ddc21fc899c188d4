#include "stillmap/map_contents.hpp"

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

MapSnapshot snapshot_of(const MapContents& map, const Decision& decision) {
  MapSnapshot snapshot;
  snapshot.stamp_ns = map.stamp_ns;
  snapshot.voxel_size_m = map.voxel_size_m;
  std::size_t voxels = 0;
  for (const BlockContents& block : map.blocks) voxels += block.voxels.size();
  snapshot.voxels.reserve(voxels);
  for (const BlockContents& block : map.blocks)
    for_each_voxel(block, [&](int place, const Voxel& voxel) {
      const Eigen::Vector3d center =
          (voxel_key(block.key, place).cast<double>().array() + 0.5) * map.voxel_size_m;
      const float log_odds = voxel.log_odds();
      snapshot.voxels.push_back({center.cast<float>(), log_odds, decision(p_from_log_odds(log_odds))});
    });
  return snapshot;
}

}  // namespace stillmap
