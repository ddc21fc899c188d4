#include "stillmap/voxel_map.hpp"

#include <algorithm>
#include <cstddef>

#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// Voxel::grow_older() on whole voxels as bytes, which fill vector registers: the sum of two bytes that is
/// less than one of them did not fit.
STILLMAP_VECTOR_CLONES void grow_older(std::uint32_t scans, std::size_t n, Voxel* voxels) {
  const auto more = static_cast<std::uint8_t>(std::min(255U, scans));
  std::uint8_t added[sizeof(Voxel)] = {};
  added[offsetof(Voxel, idle)] = added[offsetof(Voxel, age)] = more;
  auto* bytes = reinterpret_cast<std::uint8_t*>(voxels);
  for (std::size_t i = 0; i < n; ++i, bytes += sizeof(Voxel))
    for (std::size_t k = 0; k < sizeof(Voxel); ++k) {
      const auto sum = static_cast<std::uint8_t>(bytes[k] + added[k]);
      bytes[k] = sum < added[k] ? std::uint8_t{255} : sum;
    }
}

}  // namespace

void VoxelBlock::create(int place) {
  const int index = rank(place), word = place >> 6;
  occupied_[word] |= std::uint64_t{1} << (place & 63);
  for (int later = word + 1; later < kWords; ++later) ++before_[later];
  voxels_.insert(voxels_.begin() + index, Voxel{});
}

STILLMAP_VECTOR_CLONES PlaceMask VoxelBlock::create(const PlaceMask& places) {
  PlaceMask made;
  std::size_t count = 0;
  for (int word = 0; word < kWords; ++word) {
    made[word] = places[word] & ~occupied_[word];
    count += static_cast<std::size_t>(__builtin_popcountll(made[word]));
  }
  if (count == 0) return made;
  // From the end, so that each voxel moves once and over none that is still to move.
  std::size_t from = voxels_.size(), to = from + count;
  voxels_.resize(to);
  for (int word = kWords - 1; from < to; --word) {
    for (std::uint64_t bits = occupied_[word] | made[word]; bits != 0 && from < to;) {
      const std::uint64_t highest = std::uint64_t{1} << (63 - __builtin_clzll(bits));
      voxels_[--to] = (made[word] & highest) != 0 ? Voxel{} : voxels_[--from];
      bits &= ~highest;
    }
  }
  for (int word = 0; word < kWords; ++word) occupied_[word] |= made[word];
  count_before();
  return made;
}

void VoxelBlock::count_before() {
  for (int word = 1; word < kWords; ++word)
    before_[word] = static_cast<std::uint16_t>(before_[word - 1] + __builtin_popcountll(occupied_[word - 1]));
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
  count_before();
  voxels_ = contents.voxels;
  aged_scan_ = scan;
}

std::uint32_t VoxelMap::find_or_create_block(const BlockKey& key) {
  const auto next = free_.empty() ? static_cast<std::uint32_t>(block_count_) : free_.back();
  const auto [it, created] = index_.try_emplace(packed(key), next);
  if (!created) return it->second;
  if (free_.empty()) {
    if (block_count_++ % kChunk == 0) chunks_.emplace_back().reserve(kChunk);
    chunks_.back().emplace_back(key);
  } else {
    free_.pop_back();
    block(next) = VoxelBlock(key);
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
    voxel_count_ -= block(entry.index).size();
    block(entry.index) = VoxelBlock(BlockKey::Zero());
    free_.push_back(entry.index);
  }
  tiles_.erase(it);
}

void VoxelMap::restore(const BlockContents& contents, std::uint32_t scan) {
  VoxelBlock& restored = block(find_or_create_block(contents.key));
  voxel_count_ -= restored.size();
  restored.restore(contents, scan);
  voxel_count_ += restored.size();
}

}  // namespace stillmap
