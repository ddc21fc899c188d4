#include "calibration.hpp"

#include <algorithm>

#include "stillmap/log_odds.hpp"

namespace stillmap {
namespace {

/// Log-odds of standing: offset + slope L.
struct Curve {
  float offset, slope;
};

/// By Reason; as scripts/fit_calibration.py prints them.
constexpr std::array<Curve, kReasonCount> kCurves = {{
    {0.00F, 0.00F},   // no return
    {0.00F, 0.00F},   // out of range
    {3.12F, 0.00F},   // never judged
    {3.24F, 0.80F},   // mixed evidence
    {5.31F, 0.92F},   // supported
    {-0.15F, 1.19F},  // seen through now
    {-0.15F, 1.19F},  // seen through
    {-1.58F, 0.00F},  // object moves
    {5.23F, 0.00F},   // object stands
    {-4.05F, 0.00F},  // replaced vanished
    {2.50F, 1.03F},   // seen through later
}};

}  // namespace

Calibration::Calibration() {
  constexpr float kLeast = 0.015F;  // beyond it the curves stay flat
  for (std::size_t reason = 0; reason < kCurves.size(); ++reason)
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      const float p = static_cast<float>(bin) / static_cast<float>(kBins - 1);
      const float log_odds = log_odds_from_p(std::clamp(p, kLeast, 1 - kLeast));
      share_[reason][bin] = p_from_log_odds(kCurves[reason].offset + kCurves[reason].slope * log_odds);
    }
}

}  // namespace stillmap
