#include "simulation/sensor.hpp"

#include <cmath>
#include <stdexcept>

namespace stillmap::simulation {
namespace {

constexpr double kRadPerDeg = M_PI / 180.0;

std::vector<double> evenly(std::size_t count, double lowest_deg, double highest_deg) {
  std::vector<double> elevations;
  for (std::size_t i = 0; i < count; ++i) {
    elevations.push_back(lowest_deg + (highest_deg - lowest_deg) * static_cast<double>(i) /
                                          static_cast<double>(count - 1));
  }
  return elevations;
}

/// Lower block in steps of half a degree, upper block in steps of a third, as the data sheet has it.
std::vector<double> hdl64_elevations() {
  std::vector<double> elevations = evenly(32, -24.33, -8.83);
  for (const double elevation : evenly(32, -8.33, 2.0)) elevations.push_back(elevation);
  return elevations;
}

/// Close together near the horizon and 9 degrees apart at the bottom, as the data sheet has it.
std::vector<double> vlp32_elevations() {
  std::vector<double> elevations = {-25, -15.639, -11.31, -8.843, -7.254, -6.148, -5.333, -4.667};
  for (const double elevation : evenly(18, -4, 1.667)) elevations.push_back(elevation);
  for (const double elevation : {2.333, 3.333, 4.667, 7.0, 10.333, 15.0}) elevations.push_back(elevation);
  return elevations;
}

SensorModel spinning(const std::string& name, std::vector<double> elevations, std::size_t columns,
                     double max_range_m) {
  SensorModel sensor;
  sensor.name = name;
  sensor.ring_elevations_deg = std::move(elevations);
  sensor.columns = columns;
  sensor.max_range_m = max_range_m;
  return sensor;
}

SensorModel non_repetitive(const std::string& name, ScanPattern pattern, std::size_t beams_per_sweep,
                           double max_range_m) {
  SensorModel sensor;
  sensor.name = name;
  sensor.pattern = pattern;
  sensor.beams_per_sweep = beams_per_sweep;
  sensor.max_range_m = max_range_m;
  return sensor;
}

/// Columns are for 10 sweeps a second.
std::vector<SensorModel> all_sensors() {
  return {spinning("vlp16", evenly(16, -15, 15), 1800, 100),
          spinning("hdl32", evenly(32, -30.67, 10.67), 2170, 100),
          spinning("vlp32", vlp32_elevations(), 1800, 120),
          spinning("hdl64", hdl64_elevations(), 2083, 120),
          spinning("os1_64", evenly(64, -22.5, 22.5), 1024, 100),
          spinning("os1_128", evenly(128, -22.5, 22.5), 1024, 120),
          spinning("os0_128", evenly(128, -45, 45), 1024, 50),
          non_repetitive("livox", ScanPattern::kRosette, 24000, 150),
          non_repetitive("mid360", ScanPattern::kSpiral, 20000, 70)};
}

std::vector<Beam> spinning_beams(const SensorModel& sensor) {
  std::vector<Beam> beams;
  beams.reserve(sensor.beam_count());
  for (std::size_t column = 0; column < sensor.columns; ++column) {
    const double turn = static_cast<double>(column) / static_cast<double>(sensor.columns);
    for (std::size_t ring = 0; ring < sensor.ring_elevations_deg.size(); ++ring) {
      beams.push_back({turn, M_PI - 2 * M_PI * turn, sensor.ring_elevations_deg[ring] * kRadPerDeg,
                       static_cast<std::uint16_t>(ring)});
    }
  }
  return beams;
}

/// Two prisms that turn against each other draw a rosette; six lines side by side draw it together.
Beam rosette_beam(double time_s, std::size_t line) {
  constexpr double kHalfWidth_deg = 35.2, kHalfHeight_deg = 37.4, kLineGap_deg = 0.48;
  constexpr double kPrism1_hz = 121.567, kPrism2_hz = -77.733;
  const double a = 2 * M_PI * kPrism1_hz * time_s, b = 2 * M_PI * kPrism2_hz * time_s;
  const double azimuth_deg = kHalfWidth_deg * (std::cos(a) + std::cos(b)) / 2;
  const double elevation_deg = kHalfHeight_deg * (std::sin(a) + std::sin(b)) / 2;
  const double offset_deg = kLineGap_deg * (static_cast<double>(line) - 2.5);
  return {0, azimuth_deg * kRadPerDeg, (elevation_deg + offset_deg) * kRadPerDeg,
          static_cast<std::uint16_t>(line)};
}

/// A mirror nods while the head turns, at rates without a common period; four lines.
Beam spiral_beam(double time_s, std::size_t line) {
  constexpr double kLowest_deg = -7, kHighest_deg = 52, kTurn_hz = 51.317, kNod_hz = 11.731;
  const double phase = kNod_hz * time_s + static_cast<double>(line) / 4;
  const double share = std::abs(2 * (phase - std::floor(phase)) - 1);
  const double azimuth_rad = std::remainder(-2 * M_PI * kTurn_hz * time_s, 2 * M_PI);
  return {0, azimuth_rad, (kLowest_deg + (kHighest_deg - kLowest_deg) * share) * kRadPerDeg,
          static_cast<std::uint16_t>(line)};
}

}  // namespace

std::size_t SensorModel::beam_count() const {
  return pattern == ScanPattern::kSpinning ? ring_elevations_deg.size() * columns : beams_per_sweep;
}

std::vector<Beam> SensorModel::beams(std::uint64_t sweep, double period_s) const {
  if (pattern == ScanPattern::kSpinning) return spinning_beams(*this);
  std::vector<Beam> beams;
  beams.reserve(beams_per_sweep);
  for (std::size_t i = 0; i < beams_per_sweep; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(beams_per_sweep);
    const double time_s = (static_cast<double>(sweep) + share) * period_s;
    Beam beam = pattern == ScanPattern::kRosette ? rosette_beam(time_s, i % 6) : spiral_beam(time_s, i % 4);
    beam.time_share = share;
    beams.push_back(beam);
  }
  return beams;
}

SensorModel sensor_model(const std::string& name) {
  std::string known;
  for (SensorModel& sensor : all_sensors()) {
    if (sensor.name == name) return std::move(sensor);
    known += (known.empty() ? "" : ", ") + sensor.name;
  }
  throw std::invalid_argument("sensor '" + name + "' is not known: use one of " + known);
}

std::vector<std::string> sensor_model_names() {
  std::vector<std::string> names;
  for (const SensorModel& sensor : all_sensors()) names.push_back(sensor.name);
  return names;
}

}  // namespace stillmap::simulation
