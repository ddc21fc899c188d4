#include <algorithm>
#include <cmath>

#include "mapper_state.hpp"

namespace stillmap {
namespace {

constexpr std::uint32_t kStandingMemoryScans = 1;
constexpr std::uint32_t kMovingMemoryScans = 2;

}  // namespace

void Mapper::State::find_known_surface(VoxelBlock& block) const {
  constexpr int kEstablishedHits = 3;
  const auto most_idle = static_cast<int>(scans_of_all(kStandingMemoryScans));
  constexpr float kBeyondFixed = 1e5F;  // log_odds is infinite where p_static_min is 1
  const float log_odds = log_odds_from_p(decision.p_static_min) * Voxel::kLogOddsScale;
  const auto established = static_cast<int>(std::ceil(within(log_odds, -kBeyondFixed, kBeyondFixed)));
  CellMask standing = 0, porous = 0;
  block.for_each([&](int place, const Voxel& voxel) {
    const bool stands =
        (voxel.idle <= most_idle) & (voxel.hits >= kEstablishedHits) & (voxel.log_odds_fixed >= established);
    standing |= cell_bit(place, stands);
    porous |= cell_bit(place, (voxel.came_back != 0) & (voxel.log_odds_fixed > 0));
  });
  block.standing = standing;
  block.porous = porous;
}

Mapper::State::KnownSurface Mapper::State::near_known_surface(const BlockKey& key, CellMask asked) const {
  std::array<CellMask, 27> standing{}, porous{};
  for_each_around(key, asked, [&](int i, const VoxelBlock& b) {
    if (b.hit_scan + scans_of_all(kStandingMemoryScans) >= scan_count) standing[i] = b.standing;
    porous[i] = b.porous;
  });
  return {grown(standing) & asked, grown(porous) & asked};
}

CellMask Mapper::State::near_porous(const BlockKey& key, CellMask asked) const {
  return near(key, asked, [](const VoxelBlock& b) { return b.porous; });
}

void Mapper::State::remember_moving() {
  for (const std::uint32_t row : moving_rows) {
    if (labels.label[row] != Label::kDynamic || clusters.of_row()[row] == Clusters::kNone) continue;
    if (labels.reason[row] == Reason::kObjectMoves)
      continue;  // a vote is no new sighting: it must not feed itself
    VoxelBlock& block = map.block(voxel_of_row[row].block);
    if (block.moving_scan != scan_count) {
      block.moving_scan = scan_count;
      block.moving = 0;
      moving_blocks.push_back(voxel_of_row[row].block);
    }
    block.moving |= cell_bit(static_cast<int>(voxel_of_row[row].place));
  }
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

}  // namespace stillmap
