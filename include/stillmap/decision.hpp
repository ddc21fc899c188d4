#pragma once

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

}  // namespace stillmap
