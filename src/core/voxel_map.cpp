#include "stillmap/voxel_map.hpp"

#include <algorithm>

namespace stillmap {

Voxel& VoxelBlock::find_or_create(int place, bool& created) {
  const int index = rank(place);
  created = !contains(place);
  if (created) {
    voxels_.insert(voxels_.begin() + index, Voxel{});
    const int word = place >> 6;
    occupied_[word] |= std::uint64_t{1} << (place & 63);
    for (int later = word + 1; later < kWords; ++later) ++before_[later];
  }
  return voxels_[index];
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
  const auto [it, created] = index_.try_emplace(packed(key), static_cast<std::uint32_t>(blocks_.size()));
  if (created) blocks_.emplace_back(key);
  return it->second;
}

std::size_t VoxelMap::voxel_count() const {
  std::size_t count = 0;
  for (const VoxelBlock& block : blocks_) count += block.size();
  return count;
}

}  // namespace stillmap
