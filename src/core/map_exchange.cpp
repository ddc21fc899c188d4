#include <stdexcept>

#include "mapper_state.hpp"

namespace stillmap {

MapSnapshotPtr Mapper::snapshot() const {
  const State& s = *state_;
  auto snapshot = std::make_shared<MapSnapshot>();
  snapshot->stamp_ns = s.stamp_ns;
  snapshot->voxel_size_m = s.map.voxel_size_m();
  for (std::uint32_t index = 0; index < s.map.block_count(); ++index) {
    const VoxelBlock& block = s.map.block(index);
    block.for_each([&](int place, const Voxel& voxel) {
      const Eigen::Vector3f center = s.map.center_of(voxel_key(block.key(), place)).cast<float>();
      const float log_odds = voxel.log_odds();
      snapshot->voxels.push_back({center, log_odds, s.decision(p_from_log_odds(log_odds))});
    });
  }
  return snapshot;
}

MapContents Mapper::export_map() const {
  const State& s = *state_;
  MapContents contents{s.stamp_ns, s.map.voxel_size_m(), {}};
  contents.blocks.reserve(s.map.block_count());
  for (std::uint32_t index = 0; index < s.map.block_count(); ++index)
    if (s.map.block(index).size() > 0) contents.blocks.push_back(s.map.block(index).contents(s.scan_count));
  return contents;
}

void Mapper::import_map(const MapContents& contents) {
  State& s = *state_;
  if (contents.voxel_size_m != s.map.voxel_size_m())
    throw std::invalid_argument("the map's voxels are " + std::to_string(contents.voxel_size_m) +
                                " m large and voxel_size_m is " + std::to_string(s.map.voxel_size_m()) +
                                "; set voxel_size_m to the map's, or build the map anew");
  for (const BlockContents& block : contents.blocks)
    if (*problem(block) != '\0')
      throw std::invalid_argument(std::string("the map to import: ") + problem(block));
  for (const BlockContents& block : contents.blocks)
    s.map.block(s.map.find_or_create_block(block.key)).restore(block, s.scan_count);
  s.stamp_ns = std::max(s.stamp_ns, contents.stamp_ns);
}

}  // namespace stillmap
