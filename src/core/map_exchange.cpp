#include <tsl/robin_set.h>

#include <algorithm>
#include <stdexcept>

#include "mapper_state.hpp"

namespace stillmap {

MapSnapshotPtr Mapper::snapshot() const {
  const State& s = up_to_date();
  auto snapshot = std::make_shared<MapSnapshot>();
  snapshot->stamp_ns = s.stamp_ns;
  snapshot->voxel_size_m = s.map.voxel_size_m();
  snapshot->voxels.reserve(voxel_count());
  for (const TileKey& key : tiles())
    for (const BlockContents& block : s.rolling.contents(key, s.scan_count))
      append(*snapshot, block, s.decision);
  return snapshot;
}

MapContents Mapper::export_map() const {
  const State& s = up_to_date();
  MapContents contents{s.stamp_ns, s.map.voxel_size_m(), {}};
  for (const TileKey& key : tiles())
    for (BlockContents& block : export_tile(key)) contents.blocks.push_back(std::move(block));
  return contents;
}

std::vector<TileKey> Mapper::tiles() const {
  return up_to_date().rolling.tiles();
}
std::vector<BlockContents> Mapper::export_tile(const TileKey& key) const {
  const State& s = up_to_date();
  return s.rolling.contents(key, s.scan_count);
}

void Mapper::State::require_importable(const MapContents& contents) const {
  if (contents.voxel_size_m != map.voxel_size_m())
    throw std::invalid_argument("the map's voxels are " + std::to_string(contents.voxel_size_m) +
                                " m large and voxel_size_m is " + std::to_string(map.voxel_size_m()) +
                                "; set voxel_size_m to the map's, or build the map anew");
  for (const BlockContents& block : contents.blocks)
    if (*problem(block) != '\0')
      throw std::invalid_argument(std::string("the map to import: ") + problem(block));
}

void Mapper::load_map(const MapContents& contents) {
  state_->require_importable(contents);
  reset();
  import_map(contents);
}

void Mapper::import_map(const MapContents& contents) {
  State& s = up_to_date();
  s.require_importable(contents);
  s.rolling.import(contents.blocks, s.scan_count);
  s.stamp_ns = std::max(s.stamp_ns, contents.stamp_ns);
  ++s.revision;
  if (!s.submaps.enabled()) return;
  std::vector<PlacedVoxel> voxels;
  tsl::robin_set<std::uint64_t, BlockKeyHash> replaced;
  for (const BlockContents& block : contents.blocks) {
    replaced.insert(packed(block.key));
    for_each_voxel(block, [&](int place, const Voxel& voxel) {
      voxels.push_back({voxel_key(block.key, place), voxel});
    });
  }
  for (Submap& submap : s.submaps.all()) {
    const auto is_replaced = [&](const PlacedVoxel& placed) {
      return replaced.count(packed(block_key(placed.key))) != 0;
    };
    submap.voxels.erase(std::remove_if(submap.voxels.begin(), submap.voxels.end(), is_replaced),
                        submap.voxels.end());
  }
  s.submaps.add_unanchored(std::move(voxels), s.scan_count);
}

}  // namespace stillmap
