#pragma once

#include <cstdint>
#include <vector>

#include "stillmap/log_odds.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {

/// What one scan says about one spatial element at one angular level, section 1.1.2.
enum class Evidence : std::uint8_t { kUnknown, kOcclusion, kSupport, kConflict };

/// What a scan measured in a direction, metres: a single return has nearest == farthest; between beams it is
/// the span of the beams around. farthest == 0: no return.
struct MeasuredRange {
  float nearest_m = 0;
  float farthest_m = 0;
  bool valid() const { return farthest_m > 0; }
};

/// The thresholds and rates of one angular level r.
struct LevelModel {
  float epsilon_m;         ///< support threshold
  float tau_0_m, alpha;    ///< conflict threshold, eq. (3)
  float sigma_m;           ///< eq. (6)
  float eta, kappa;        ///< rates of eq. (5)
  float eta_when_dynamic;  ///< eta while L < 0
  ConflictStrength form;
  /// Orders the levels by eta: 1 for the smallest, the same for equal ones; 0 where eta is 0.
  int support_rank = 1;

  /// Eq. (3).
  float tau_m(float range_m) const { return alpha * range_m + tau_0_m; }
  /// What lies between two beams farther apart than this is not one surface.
  float one_surface_m(float range_m) const { return 2 * epsilon_m + 0.1F * range_m; }
};
/// One model for each of angular_levels_deg.
std::vector<LevelModel> level_models(const Parameters& parameters);

/// Eq. (2) and the four cases. `range_m` is the element's range I_M; d = I_O - I_M is taken to the end of the
/// span that speaks against the case: a conflict needs every beam around to pass, an occlusion every beam to
/// be stopped. A span too long to be one surface (a depth edge) supports nothing.
inline Evidence classify(float range_m, MeasuredRange measured, const LevelModel& level) {
  if (!measured.valid()) return Evidence::kUnknown;
  if (measured.nearest_m - range_m > level.tau_m(range_m)) return Evidence::kConflict;
  if (measured.farthest_m - range_m < -level.epsilon_m) return Evidence::kOcclusion;
  const bool inside = measured.nearest_m - range_m <= level.epsilon_m;
  const bool one_surface = measured.farthest_m - measured.nearest_m <= level.one_surface_m(range_m);
  return inside && one_surface ? Evidence::kSupport : Evidence::kUnknown;
}

/// The evidence of all levels of one scan about one element, section 1.2.2 (1): conflict first, its strongest
/// g wins; else support, at its largest rate; occlusion and unknown change nothing.
class FusedEvidence {
 public:
  void add(Evidence evidence, float range_m, MeasuredRange measured, const LevelModel& level) {
    if (evidence == Evidence::kConflict) {
      const float d_m = measured.nearest_m - range_m;
      const float strength = conflict_strength(level.form, d_m, level.tau_m(range_m), level.sigma_m);
      conflict_ = std::min(conflict_, conflict_increment(level.kappa, strength));
    } else if (evidence == Evidence::kSupport) {
      support(level);
    }
  }
  void support(const LevelModel& level) {
    eta_ = std::max(eta_, level.eta);
    eta_when_dynamic_ = std::max(eta_when_dynamic_, level.eta_when_dynamic);
  }

  Evidence kind() const {
    return conflict_ < 0 ? Evidence::kConflict : eta_ > 0 ? Evidence::kSupport : Evidence::kUnknown;
  }
  /// dL of eq. (4) for an element that stands at `log_odds`.
  float increment(float log_odds) const {
    return conflict_ < 0 ? conflict_ : increment(log_odds, p_from_log_odds(log_odds));
  }
  /// The same where p is already known.
  float increment(float log_odds, float p_static) const {
    return conflict_ < 0 ? conflict_ : support_increment(eta(log_odds), p_static);
  }
  /// The rate of support for it; 0 where there is none.
  float eta(float log_odds) const { return log_odds < 0 ? eta_when_dynamic_ : eta_; }

 private:
  float conflict_ = 0;
  float eta_ = 0, eta_when_dynamic_ = 0;
};

}  // namespace stillmap
