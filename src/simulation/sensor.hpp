#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace stillmap::simulation {

/// One shot of the laser, in the sensor frame (x ahead, y left, z up).
struct Beam {
  double time_share;  ///< of the sweep, 0 to 1, never decreasing
  double azimuth_rad;
  double elevation_rad;
  std::uint16_t ring;
};

/// How the beams of a sweep lie.
enum class ScanPattern {
  kSpinning,  ///< rings at fixed elevations, turning clockwise from behind
  kRosette,   ///< non-repetitive, in front (Livox Avia)
  kSpiral     ///< non-repetitive, all around (Livox Mid-360)
};

struct SensorModel {
  std::string name;
  ScanPattern pattern = ScanPattern::kSpinning;
  std::vector<double> ring_elevations_deg;  ///< spinning: lowest first
  std::size_t columns = 0;                  ///< spinning: shots of a ring in a sweep
  std::size_t beams_per_sweep = 0;          ///< non-repetitive
  double min_range_m = 0.5;
  double max_range_m = 120.0;
  double footprint_deg = 0.1;  ///< of the beam: where it meets an edge, ranges mix
  double jitter_deg = 0.01;    ///< sigma of the true against the reported direction

  std::size_t beam_count() const;
  /// In order of time. A non-repetitive pattern goes on from sweep to sweep.
  std::vector<Beam> beams(std::uint64_t sweep, double period_s) const;
};

/// Throws std::invalid_argument listing the names.
SensorModel sensor_model(const std::string& name);
std::vector<std::string> sensor_model_names();

}  // namespace stillmap::simulation
