#pragma once

#include <optional>

#include "simulation/random.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/sensor.hpp"

namespace stillmap::simulation {

/// What goes wrong on the way to a measured range.
struct ReturnNoise {
  double range_noise_m = 0.02;  ///< sigma
  double drop_share = 0.01;     ///< of all returns, at random
  bool physical = true;         ///< weak returns get lost, beams jitter, ranges mix at edges
  static ReturnNoise none() { return {0.0, 0.0, false}; }
};

struct LaserReturn {
  double range_m;
  float intensity;  ///< 0 to 1
};

/// What the sensor reports of a hit; nothing if the light does not come back.
std::optional<LaserReturn> measure(const Hit& hit, const ReturnNoise& noise, Random* random);

/// The range of a beam that meets two surfaces at once: between the two, where they are near each other.
double mixed_range_m(double nearer_m, double farther_m, Random* random);

}  // namespace stillmap::simulation
