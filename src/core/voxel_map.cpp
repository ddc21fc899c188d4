#include "stillmap/voxel_map.hpp"

#include <algorithm>

#include "vector_clones.hpp"

namespace stillmap {
namespace {

STILLMAP_VECTOR_CLONES void grow_older(std::uint32_t scans, std::size_t n, Voxel* voxels) {
  for (std::size_t i = 0; i < n; ++i) voxels[i].grow_older(scans);
}

}  // namespace

void VoxelBlock::create(int place) {
  const int index = rank(place), word = place >> 6;
  occupied_[word] |= std::uint64_t{1} << (place & 63);
  for (int later = word + 1; later < kWords; ++later) ++before_[later];
  voxels_.insert(voxels_.begin() + index, Voxel{});
}

void VoxelBlock::age(std::uint32_t scan) {
  const std::uint32_t scans = scan - aged_scan_;
  aged_scan_ = scan;
  if (scans > 0) grow_older(scans, voxels_.size(), voxels_.data());
}

Voxel VoxelBlock::as_of(int place, std::uint32_t scan) const {
  Voxel voxel = at(place);
  voxel.grow_older(scan - aged_scan_);
  return voxel;
}

BlockContents VoxelBlock::contents(std::uint32_t scan) const {
  return aged({key_, porous, occupied_, voxels_}, scan - aged_scan_);
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
  for_each_tile_near(center_map_m, reach_m, [&](const TileKey& key) {
    if (const BlockTile* const here = tile(key)) tiles.push_back(here);
  });
}

void VoxelMap::erase_tile(const TileKey& key) {
  const auto it = tiles_.find(packed_tile(key));
  if (it == tiles_.end()) return;
  for (const BlockEntry& entry : it->second) {
    index_.erase(packed(entry.key));
    voxel_count_ -= blocks_[entry.index].size();
    blocks_[entry.index] = VoxelBlock(BlockKey::Zero());
    free_.push_back(entry.index);
  }
  tiles_.erase(it);
}

void VoxelMap::restore(const BlockContents& contents, std::uint32_t scan) {
  VoxelBlock& block = blocks_[find_or_create_block(contents.key)];
  voxel_count_ -= block.size();
  block.restore(contents, scan);
  voxel_count_ += block.size();
}

}  // namespace stillmap
