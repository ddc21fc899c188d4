#pragma once

#include <algorithm>

#include "stillmap/voxel.hpp"

namespace stillmap {

/// Two voxels of one place in different maps as one: their log-odds add up inside the bounds of L, and so do
/// their counts.
inline Voxel sum(const Voxel& a, const Voxel& b, float log_odds_min, float log_odds_max) {
  Voxel voxel = a.hits >= b.hits ? a : b;  // its surface is the better known
  voxel.set_log_odds(std::clamp(a.log_odds() + b.log_odds(), log_odds_min, log_odds_max));
  voxel.hits = static_cast<std::uint8_t>(std::min(0xFF, a.hits + b.hits));
  voxel.idle = std::min(a.idle, b.idle);
  voxel.age = std::max(a.age, b.age);
  voxel.seen_through = static_cast<std::uint8_t>(std::min(0x3F, a.seen_through + b.seen_through)) & 0x3F;
  voxel.moved_in = (a.moved_in | b.moved_in) & 1;
  voxel.came_back = (a.came_back | b.came_back) & 1;
  return voxel;
}

}  // namespace stillmap
