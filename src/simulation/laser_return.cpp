#include "simulation/laser_return.hpp"

#include <algorithm>
#include <cmath>

namespace stillmap::simulation {
namespace {

/// Falls with the square of the range and with a grazing angle; asphalt is half lost at about 50 m, a wall
/// at about 150 m.
double return_probability(const Hit& hit) {
  const double reference_ranges = 80.0 / std::max(1.0, hit.range_m);
  const double strength = static_cast<double>(hit.surface.reflectivity) * (0.1 + hit.incidence_cos) *
                          reference_ranges * reference_ranges;
  return static_cast<double>(hit.surface.return_probability) * (1.0 - std::exp(-15.0 * strength));
}

}  // namespace

std::optional<LaserReturn> measure(const Hit& hit, const ReturnNoise& noise, Random* random) {
  if (random->chance(noise.drop_share)) return std::nullopt;
  if (noise.physical && !random->chance(return_probability(hit))) return std::nullopt;
  const double brightness = static_cast<double>(hit.surface.reflectivity) * (0.3 + 0.7 * hit.incidence_cos);
  const double flicker = noise.physical ? 0.02 * random->normal() : 0.0;
  return LaserReturn{hit.range_m + noise.range_noise_m * random->normal(),
                     static_cast<float>(std::clamp(brightness + flicker, 0.0, 1.0))};
}

double mixed_range_m(double nearer_m, double farther_m, Random* random) {
  constexpr double kPulseLength_m =
      1.5;  // surfaces farther apart give two returns, of which the first counts
  if (farther_m - nearer_m > kPulseLength_m) return nearer_m;
  return random->uniform(nearer_m, farther_m);
}

}  // namespace stillmap::simulation
