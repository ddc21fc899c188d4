#include "stillmap/sensor_geometry.hpp"

#include <algorithm>

namespace stillmap {
namespace {

constexpr float kRad = 0.01745329252F;

/// The value below which `fraction` of the values lie; reorders them.
float quantile(std::vector<float>& values, double fraction) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(fraction * (values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// Sorts `angle` inside bins of `bin_angle` and returns the gaps between neighbours that are at least
/// `floor_rad`.
std::vector<float> gaps_inside_bins(const std::vector<float>& bin_angle, const std::vector<float>& angle,
                                    const std::vector<float>& range_m, float bin_rad, float floor_rad) {
  constexpr float kHalfTurn = 3.15F;  // no angle is larger
  const int first_bin = static_cast<int>(std::floor(-kHalfTurn / bin_rad));
  const auto bin_of = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<int>(std::floor(bin_angle[i] / bin_rad)) - first_bin);
  };
  std::vector<std::size_t> end(static_cast<std::size_t>(2 - 2 * first_bin),
                               0);  // of each bin, among its angles
  for (std::size_t i = 0; i < angle.size(); ++i)
    if (range_m[i] > 0) ++end[bin_of(i)];
  for (std::size_t bin = 1; bin < end.size(); ++bin) end[bin] += end[bin - 1];
  std::vector<float> sorted(end.back());
  std::vector<std::size_t> begin = end;
  for (std::size_t i = 0; i < angle.size(); ++i)
    if (range_m[i] > 0) sorted[--begin[bin_of(i)]] = angle[i];
  std::vector<float> gaps;
  gaps.reserve(sorted.size());
  for (std::size_t bin = 0; bin < end.size(); ++bin) {
    const auto of_bin = sorted.begin();
    std::sort(of_bin + static_cast<std::ptrdiff_t>(begin[bin]),
              of_bin + static_cast<std::ptrdiff_t>(end[bin]));
    for (std::size_t i = begin[bin] + 1; i < end[bin]; ++i)
      if (const float gap = sorted[i] - sorted[i - 1]; gap >= floor_rad) gaps.push_back(gap);
  }
  return gaps;
}

/// Mean angle between neighbouring returns of a scan without order: the root of the solid angle, in azimuth
/// times elevation, that one return has. The field of view is counted in cells.
float mean_spacing_rad(const ProjectedScan& scan) {
  constexpr float kCell = 4.0F * kRad, kHalfTurn = 3.14159265F;
  constexpr int kColumns = 91, kRows = 46;
  std::vector<char> occupied(kColumns * kRows, 0);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!(scan.range_m[i] > 0)) continue;
    const int column = static_cast<int>((scan.azimuth_rad[i] + kHalfTurn) / kCell);
    const int row = static_cast<int>((scan.elevation_rad[i] + 0.5F * kHalfTurn) / kCell);
    occupied[column * kRows + row] = 1;
  }
  const auto cells = static_cast<float>(std::count(occupied.begin(), occupied.end(), 1));
  return kCell * std::sqrt(cells / static_cast<float>(std::max<std::size_t>(1, scan.judged)));
}

}  // namespace

SensorGeometry measure_geometry(const ProjectedScan& scan) {
  constexpr std::size_t kEnough = 50;
  // Thin columns hold a return or two of each ring: their larger gaps are the ring spacing. Rows thinner than
  // a ring hold one ring: their middle gap is the azimuth step.
  std::vector<float> rings =
      gaps_inside_bins(scan.azimuth_rad, scan.elevation_rad, scan.range_m, 0.4F * kRad, 0.03F * kRad);
  std::vector<float> steps =
      gaps_inside_bins(scan.elevation_rad, scan.azimuth_rad, scan.range_m, 0.1F * kRad, 0.02F * kRad);
  SensorGeometry found;
  if (rings.size() >= kEnough) found.ring_spacing_rad = quantile(rings, 0.75);
  if (steps.size() >= kEnough) found.azimuth_step_rad = quantile(steps, 0.5);
  // Rings and steps must explain how many returns there are; else the pattern has neither.
  constexpr float kFarFromRings = 3.0F;
  const float mean_rad = mean_spacing_rad(scan);
  if (found.ring_spacing_rad * found.azimuth_step_rad > kFarFromRings * mean_rad * mean_rad)
    found.ring_spacing_rad = found.azimuth_step_rad = mean_rad;
  return found;
}

SensorGeometry GeometryEstimator::update(const ProjectedScan& scan) {
  if (ring_spacings_.size() < kScans) {
    const SensorGeometry found = measure_geometry(scan);
    if (found.ring_spacing_rad > 0 && found.azimuth_step_rad > 0) {
      ring_spacings_.push_back(found.ring_spacing_rad);
      azimuth_steps_.push_back(found.azimuth_step_rad);
    }
  }
  SensorGeometry geometry{0.5F * kRad, 0.2F * kRad};  // until a scan can tell
  if (!ring_spacings_.empty()) {
    std::vector<float> rings = ring_spacings_, steps = azimuth_steps_;
    geometry = {quantile(rings, 0.5), quantile(steps, 0.5)};
  }
  if (given_.ring_spacing_rad > 0) geometry.ring_spacing_rad = given_.ring_spacing_rad;
  if (given_.azimuth_step_rad > 0) geometry.azimuth_step_rad = given_.azimuth_step_rad;
  return geometry;
}

}  // namespace stillmap
