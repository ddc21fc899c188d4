#pragma once

#include <array>

#include "stillmap/types.hpp"

namespace stillmap {

/// How probable it is that a point stands, given why its label was chosen and the p of eq. (1). That p starts
/// every place at 0.5 and counts scans as if they erred independently; of points labelled, most stand. The
/// logistic curves here were fitted to labelled sequences: see "Calibration" in doc/accuracy.md.
class Calibration {
 public:
  Calibration();
  /// `p_static` of eq. (1), 0 to 1.
  float operator()(Reason reason, float p_static) const {
    // Never negative, and std::lround would be a call for each point.
    // NOLINTNEXTLINE(bugprone-incorrect-roundings)
    const auto bin = static_cast<std::size_t>(p_static * (kBins - 1) + 0.5F);
    return share_[static_cast<std::size_t>(reason)][bin];
  }

 private:
  static constexpr std::size_t kBins = 101;
  std::array<std::array<float, kBins>, kReasonCount> share_;
};

}  // namespace stillmap
