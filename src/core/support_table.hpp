#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "stillmap/evidence.hpp"
#include "stillmap/voxel.hpp"

namespace stillmap {

/// Where support at one rate takes every log-odds that a voxel can hold: eq. (4), (5), (7), (8), worked out
/// once.
class SupportTable {
 public:
  /// `eta_when_dynamic` is the rate while L < 0.
  SupportTable(float eta, float eta_when_dynamic, const Recursion& recursion) {
    after_.reserve(kMax - kMin + 1);
    for (int fixed = kMin; fixed <= kMax; ++fixed) {
      Voxel voxel;
      voxel.log_odds_fixed = static_cast<std::int16_t>(fixed);
      const float log_odds = voxel.log_odds();
      const float rate = log_odds < 0 ? eta_when_dynamic : eta;
      voxel.set_log_odds(recursion(log_odds, support_increment(rate, p_from_log_odds(log_odds))));
      after_.push_back(voxel.log_odds_fixed);
    }
  }
  void support(Voxel& voxel) const {
    const std::int16_t after = after_[voxel.log_odds_fixed - kMin];
    if (after != voxel.log_odds_fixed) voxel.log_odds_fixed = after;  // most are at rest: memory not written
  }

 private:
  static constexpr int kMin = std::numeric_limits<std::int16_t>::min();
  static constexpr int kMax = std::numeric_limits<std::int16_t>::max();
  std::vector<std::int16_t> after_;
};

/// A table for each LevelModel::support_rank, and what a return from the element itself does.
class SupportTables {
 public:
  /// `full_on_return`: a voxel hit again after it was seen through gets the full rate of the first level.
  SupportTables(const std::vector<LevelModel>& models, const Recursion& recursion, bool full_on_return);

  const SupportTable& of_rank(int rank) const { return by_rank_[static_cast<std::size_t>(rank)]; }
  /// Of a return of the present scan from the voxel.
  const SupportTable& of_hit(const Voxel& voxel) const {
    return voxel.came_back != 0 ? returned_ : by_rank_.back();
  }

 private:
  std::vector<SupportTable> by_rank_;
  SupportTable returned_;
};

}  // namespace stillmap
