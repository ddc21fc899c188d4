#include <algorithm>

#include "mapper_state.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

constexpr std::uint32_t kStandingMemoryScans = 1;
constexpr std::uint32_t kMovingMemoryScans = 2;

STILLMAP_VECTOR_CLONES void find_standing(std::size_t n, const Voxel* voxels, std::uint32_t most_idle,
                                          float established, std::uint8_t* __restrict stands) {
  constexpr int kEstablishedHits = 3;
  for (std::size_t i = 0; i < n; ++i)
    stands[i] = (voxels[i].idle <= most_idle) & (voxels[i].hits >= kEstablishedHits) &
                (voxels[i].log_odds() >= established);
}

}  // namespace

void Mapper::State::find_known_surface(VoxelBlock& block) const {
  std::uint8_t stands[kBlockVolume];
  find_standing(block.size(), &block.stored(0), scans_of_all(kStandingMemoryScans),
                log_odds_from_p(decision.p_static_min), stands);
  CellMask standing = 0, porous = 0;
  const std::uint8_t* voxel_stands = stands;
  block.for_each([&](int place, const Voxel& voxel) {
    standing |= cell_bit(place, *voxel_stands++ != 0);
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

CellMask Mapper::State::near_moving(const BlockKey& key, CellMask asked) const {
  if (around_moving.count(packed(key)) == 0) return 0;
  return near(key, asked, [this](const VoxelBlock& b) {
    return b.moving_scan + scans_of_all(kMovingMemoryScans) >= scan_count ? b.moving : CellMask{0};
  });
}

void Mapper::State::remember_moving() {
  for (std::size_t row = 0; row < voxel_of_row.size(); ++row) {
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
  around_moving.clear();
  for (const std::uint32_t index : moving_blocks)
    for (int i = 0; i < 27; ++i)
      around_moving.insert(packed(map.block(index).key() + BlockKey(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
}

}  // namespace stillmap
