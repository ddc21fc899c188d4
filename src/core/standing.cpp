#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::find_standing_surface() {
  constexpr int kEstablishedHits = 3;
  const float established = log_odds_from_p(decision.p_static_min);
  for (const std::uint32_t index : hit_blocks) {
    VoxelBlock& block = map.block(index);
    block.standing = 0;
    block.for_each([&](int place, const Voxel& voxel) {
      if (voxel.idle == 0 && voxel.hits >= kEstablishedHits && voxel.log_odds() >= established)
        block.standing |= CellMask{1} << cell_of_place(place);
    });
  }
}

CellMask Mapper::State::near_standing_surface(const BlockKey& key) const {
  std::array<CellMask, 27> around{};
  for (int i = 0; i < 27; ++i) {
    const std::int64_t index = map.find_block(key + BlockKey(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
    if (index < 0) continue;
    const VoxelBlock& block = map.block(static_cast<std::uint32_t>(index));
    if (block.last_hit == scan_count) around[i] = block.standing;
  }
  return grown(around);
}

}  // namespace stillmap
