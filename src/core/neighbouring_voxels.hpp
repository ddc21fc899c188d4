#pragma once

#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// Finds voxels one after the other: those that follow each other mostly lie in one block. The map must not
/// change meanwhile.
class NeighbouringVoxels {
 public:
  explicit NeighbouringVoxels(const VoxelMap& map) : map_(map) {}

  /// nullptr where there is none.
  const Voxel* find(const VoxelKey& key) {
    if (const BlockKey of_voxel = block_key(key); !is_first_found_ || of_voxel != of_block_) {
      const std::int64_t index = map_.find_block(of_voxel);
      block_ = index < 0 ? nullptr : &map_.block(static_cast<std::uint32_t>(index));
      of_block_ = of_voxel;
      is_first_found_ = true;
    }
    const int place = place_in_block(key);
    return block_ != nullptr && block_->contains(place) ? &block_->at(place) : nullptr;
  }

 private:
  const VoxelMap& map_;
  bool is_first_found_ = false;
  BlockKey of_block_ = BlockKey::Zero();
  const VoxelBlock* block_ = nullptr;
};

}  // namespace stillmap
