#include <cmath>

#include "mapper_state.hpp"

namespace stillmap {
namespace {

constexpr std::uint32_t kStandingMemoryScans = 1;

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

}  // namespace stillmap
