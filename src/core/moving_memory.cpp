#include <algorithm>

#include "mapper_state.hpp"

namespace stillmap {
namespace {

constexpr std::uint32_t kMovingMemoryScans = 2;

}  // namespace

// A vote is no sighting: it must not feed itself. Nor is a leaf that was seen through on a bush that stands.
bool Mapper::State::saw_mover(std::uint32_t row) const {
  return labels.label[row] == Label::kDynamic && labels.reason[row] != Reason::kObjectMoves &&
         belongs_to_mover(static_cast<std::int32_t>(row));
}

void Mapper::State::remember_moving() {
  for (const std::uint32_t row : moving_rows) {
    if (!saw_mover(row)) continue;
    const std::uint32_t index = block_of(row);
    VoxelBlock& block = map.block(index);
    if (block.moving_scan != scan_count) {
      block.moving_scan = scan_count;
      block.moving = 0;
      moving_blocks.push_back(index);
    }
    block.moving |= cell_bit(located.place[row]);
  }
  spread_moving();
}

void Mapper::State::spread_moving() {
  std::sort(moving_blocks.begin(), moving_blocks.end());
  moving_blocks.erase(std::unique(moving_blocks.begin(), moving_blocks.end()), moving_blocks.end());
  const auto forgotten = [this](std::uint32_t index) {
    return map.block(index).moving_scan + scans_of_all(kMovingMemoryScans) <= scan_count;
  };
  moving_blocks.erase(std::remove_if(moving_blocks.begin(), moving_blocks.end(), forgotten),
                      moving_blocks.end());
  moving_around.clear();
  for (const std::uint32_t index : moving_blocks) {
    const VoxelBlock& block = map.block(index);
    for (int i = 0; i < 27; ++i) {
      const BlockKey step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      if ((block.moving & facing(step.x(), step.y(), step.z())) == 0) continue;
      std::array<CellMask, 27> around{};  // as that neighbour sees it, which lies on the other side
      around[26 - i] = block.moving;
      moving_around[packed(block.key() + step)] |= grown(around);
    }
  }
}

// What a mover was seen in or beside is known no more: it may have stood there. What stands there still is
// hit again, and is known after a scan or two; what was vacated is not, and the next beams through it settle
// it.
void Mapper::State::doubt_beside_movers() {
  constexpr float kUntold = 0.0F, kHardlyStatic = 0.5F;  // log-odds
  const auto doubt = [](Voxel& voxel, float most) {
    if (voxel.came_back == 0 && voxel.log_odds() > most) voxel.set_log_odds(most);
  };
  for (const std::uint32_t row : moving_rows)
    if (saw_mover(row)) doubt(map.block(block_of(row)).at(located.place[row]), kUntold);
  for (const auto& [key, cells] : moving_around) {
    const std::int64_t index = map.find_block(unpacked(key));
    if (index < 0) continue;
    VoxelBlock& block = map.block(static_cast<std::uint32_t>(index));
    block.age(scan_count);
    const CellMask beside = cells;
    block.for_each([&](int place, Voxel& voxel) {
      if (voxel.idle > 0 && (beside & cell_bit(place)) != 0) doubt(voxel, kHardlyStatic);
    });
  }
}

}  // namespace stillmap
