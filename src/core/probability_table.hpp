#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "stillmap/log_odds.hpp"
#include "stillmap/voxel.hpp"

namespace stillmap {

/// p_from_log_odds() of every log-odds that a voxel can hold.
class ProbabilityTable {
 public:
  ProbabilityTable() {
    p_.reserve(kMax - kMin + 1);
    for (int fixed = kMin; fixed <= kMax; ++fixed)
      p_.push_back(p_from_log_odds(static_cast<float>(fixed) / Voxel::kLogOddsScale));
  }
  float operator[](std::int16_t log_odds_fixed) const { return p_[log_odds_fixed - kMin]; }

 private:
  static constexpr int kMin = std::numeric_limits<std::int16_t>::min();
  static constexpr int kMax = std::numeric_limits<std::int16_t>::max();
  std::vector<float> p_;
};

}  // namespace stillmap
