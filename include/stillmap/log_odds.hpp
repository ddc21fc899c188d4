#pragma once

#include <algorithm>
#include <cmath>

namespace stillmap {

/// Eq. (1): L = log(p / (1 - p)).
inline float log_odds_from_p(float p) {
  return std::log(p / (1.0F - p));
}
inline float p_from_log_odds(float log_odds) {
  return 1.0F / (1.0F + std::exp(-log_odds));
}

/// The form of g in eq. (6).
enum class ConflictStrength { kLinear, kSigmoid };

/// Eq. (6): strength in (0, 1] of a conflict, d > tau; both in metres. The sigmoid form is 0.5 at d = tau +
/// sigma / 2 and reaches 0.98 at tau + sigma.
inline float conflict_strength(ConflictStrength form, float d_m, float tau_m, float sigma_m) {
  const float linear = (d_m - tau_m) / sigma_m;
  if (form == ConflictStrength::kLinear) return std::min(1.0F, linear);
  return 1.0F / (1.0F + std::exp(-8.0F * (linear - 0.5F)));
}

/// Eq. (5), (7): support saturates with p.
inline float support_increment(float eta, float p_static) {
  return eta * (1.0F - p_static);
}

/// Eq. (5): conflict takes kappa g(d) away.
inline float conflict_increment(float kappa, float strength) {
  return -kappa * strength;
}

/// std::clamp by values: two instructions and no branch.
inline float within(float value, float low, float high) {
  return std::min(std::max(value, low), high);
}

/// The anti-accumulation rules of section 1.2.2, and where L may go.
struct Recursion {
  float increment_clip;
  float forgetting;  ///< lambda
  float log_odds_min, log_odds_max;

  /// Eq. (4) with eq. (8): L <- (1 - lambda) L + clip(dL), kept inside its bounds.
  float operator()(float log_odds, float increment) const {
    const float clipped = within(increment, -increment_clip, increment_clip);
    return within((1.0F - forgetting) * log_odds + clipped, log_odds_min, log_odds_max);
  }
};

}  // namespace stillmap
