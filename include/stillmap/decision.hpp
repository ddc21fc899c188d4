#pragma once

#include "stillmap/parameters.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// Eq. (9): two thresholds; what lies between them is deferred.
struct Decision {
  float p_static_min;   ///< tau_sta
  float p_dynamic_max;  ///< tau_dyn

  Label operator()(float p_static) const {
    if (p_static >= p_static_min) return Label::kStatic;
    if (p_static <= p_dynamic_max) return Label::kDynamic;
    return Label::kUncertain;
  }
};

inline Decision decision_of(const Parameters& parameters) {
  return {static_cast<float>(parameters.p_static_min), static_cast<float>(parameters.p_dynamic_max)};
}

}  // namespace stillmap
