#pragma once

#include <cmath>
#include <cstdint>

namespace stillmap::simulation {

/// SplitMix64: the same numbers from every standard library, and a new stream for each (seed, scan, ray)
/// costs nothing, so that no result depends on the order of calls.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0, std::uint64_t substream = 0)
      : state_(mix(mix(mix(seed) + stream) + substream)) {}

  std::uint64_t next() { return mix(state_ += 0x9e3779b97f4a7c15ULL); }
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }  ///< [0, 1)
  double uniform(double min, double max) { return min + (max - min) * uniform(); }
  int integer(int min, int max) {  ///< both ends included
    return min + static_cast<int>(next() % static_cast<std::uint64_t>(max - min + 1));
  }
  bool chance(double probability) { return uniform() < probability; }
  double normal() {  ///< Box-Muller
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * M_PI * uniform());
  }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace stillmap::simulation
