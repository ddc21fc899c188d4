#include "stillmap/voxel_map.hpp"

#include <algorithm>

namespace stillmap {

Voxel& VoxelBlock::create(int place) {
  const int index = rank(place), word = place >> 6;
  occupied_[word] |= std::uint64_t{1} << (place & 63);
  for (int later = word + 1; later < kWords; ++later) ++before_[later];
  return *voxels_.insert(voxels_.begin() + index, Voxel{});
}

void VoxelBlock::age(std::uint32_t scan) {
  const std::uint32_t scans = scan - aged_scan_;
  aged_scan_ = scan;
  if (scans == 0) return;
  for (Voxel& voxel : voxels_) {
    voxel.idle = static_cast<std::uint8_t>(std::min(255U, voxel.idle + scans));
    voxel.age = static_cast<std::uint8_t>(std::min(255U, voxel.age + scans));
  }
}

BlockContents VoxelBlock::contents(std::uint32_t scan) const {
  VoxelBlock copy = *this;
  copy.age(scan);
  return {key_, porous, occupied_, std::move(copy.voxels_)};
}

void VoxelBlock::restore(const BlockContents& contents, std::uint32_t scan) {
  *this = VoxelBlock(contents.key);
  porous = contents.porous;
  occupied_ = contents.occupied;
  for (int word = 1; word < kWords; ++word)
    before_[word] = static_cast<std::uint16_t>(before_[word - 1] + __builtin_popcountll(occupied_[word - 1]));
  voxels_ = contents.voxels;
  aged_scan_ = scan;
}

std::uint32_t VoxelMap::find_or_create_block(const BlockKey& key) {
  const auto next = free_.empty() ? static_cast<std::uint32_t>(blocks_.size()) : free_.back();
  const auto [it, created] = index_.try_emplace(packed(key), next);
  if (!created) return it->second;
  if (free_.empty()) {
    blocks_.emplace_back(key);
  } else {
    free_.pop_back();
    blocks_[next] = VoxelBlock(key);
  }
  tiles_[packed_tile(tile_key(key))].push_back({key, next});
  return next;
}

void VoxelMap::find_near(const Eigen::Vector3d& center_map_m, double reach_m,
                         std::vector<const BlockTile*>& tiles) const {
  tiles.clear();
  const double tile_m = block_size_m() * kTileEdge;
  const Eigen::Array2d center = center_map_m.head<2>().array() / tile_m;
  const double reach = reach_m / tile_m;
  const Eigen::Array2i first = (center - reach).floor().cast<int>(),
                       last = (center + reach).floor().cast<int>();
  for (int y = first.y(); y <= last.y(); ++y)
    for (int x = first.x(); x <= last.x(); ++x) {
      const Eigen::Array2d corner(x, y);
      const Eigen::Array2d nearest = center.max(corner).min(corner + 1);
      const BlockTile* const here = tile({x, y});
      if (here == nullptr || (center - nearest).matrix().squaredNorm() > reach * reach) continue;
      tiles.push_back(here);
    }
}

void VoxelMap::erase_tile(const TileKey& key) {
  const auto it = tiles_.find(packed_tile(key));
  if (it == tiles_.end()) return;
  for (const BlockEntry& entry : it->second) {
    index_.erase(packed(entry.key));
    blocks_[entry.index] = VoxelBlock(BlockKey::Zero());
    free_.push_back(entry.index);
  }
  tiles_.erase(it);
}

std::size_t VoxelMap::voxel_count() const {
  std::size_t count = 0;
  for (const VoxelBlock& block : blocks_) count += block.size();
  return count;
}

}  // namespace stillmap
