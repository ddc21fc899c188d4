#include "stillmap/sensor_geometry.hpp"

#include <algorithm>
#include <cstdint>

namespace stillmap {
namespace {

constexpr float kRad = 0.01745329252F;

/// The value below which `fraction` of the values lie; reorders them.
float quantile(std::vector<float>& values, double fraction) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(fraction * (values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// Bins of one angle: the first of them begins `shift` bins below where it would, one in `of` is looked at.
struct Bins {
  float width_rad, shift = 0;
  std::uint32_t of = 1;

  /// Scattered, so that neither rings at even distances nor a narrow field of view fall between them.
  bool looked_at(std::size_t bin) const {
    return (static_cast<std::uint32_t>(bin) * 2654435769U) >> 16 < 65536U / of;
  }
};

/// Sorts `angle` inside bins of `bin_angle` and returns the gaps between neighbours that are at least
/// `floor_rad`.
std::vector<float> gaps_inside_bins(const std::vector<float>& bin_angle, const std::vector<float>& angle,
                                    const std::vector<float>& range_m, Bins bins, float floor_rad) {
  constexpr float kHalfTurn = 3.15F;  // no angle is larger
  const int first_bin = static_cast<int>(std::floor(-kHalfTurn / bins.width_rad));
  std::vector<std::vector<float>> angles(static_cast<std::size_t>(2 - 2 * first_bin));
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const float at = std::floor(bin_angle[i] / bins.width_rad + bins.shift);
    const auto bin = static_cast<std::size_t>(static_cast<int>(at) - first_bin);
    if (range_m[i] > 0 && bins.looked_at(bin)) angles[bin].push_back(angle[i]);
  }
  std::vector<float> gaps;
  for (std::vector<float>& of_bin : angles) {
    std::sort(of_bin.begin(), of_bin.end());
    for (std::size_t i = 1; i < of_bin.size(); ++i)
      if (const float gap = of_bin[i] - of_bin[i - 1]; gap >= floor_rad) gaps.push_back(gap);
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

/// Most steps of a ring are alike.
bool are_alike(std::vector<float>& steps) {
  constexpr float kAlike = 1.6F;
  return quantile(steps, 0.5) < kAlike * quantile(steps, 0.25);
}

/// Zeros where the bins that are looked at hold too little.
SensorGeometry measure(const ProjectedScan& scan, std::uint32_t one_bin_in) {
  constexpr std::size_t kEnough = 50;
  constexpr float kMoreThanAReturnHas = 1.2F;
  // Thin columns hold a return or two of each ring: their larger gaps are the ring spacing. Rows thinner than
  // a ring hold one ring: their middle gap is the azimuth step, where no edge of a row goes along the ring.
  const Bins columns{0.4F * kRad, 0, one_bin_in};
  std::vector<float> rings =
      gaps_inside_bins(scan.azimuth_rad, scan.elevation_rad, scan.range_m, columns, 0.03F * kRad);
  SensorGeometry found;
  for (const float shift : {0.0F, 0.5F}) {
    const Bins rows{0.1F * kRad, shift, one_bin_in};
    std::vector<float> steps =
        gaps_inside_bins(scan.elevation_rad, scan.azimuth_rad, scan.range_m, rows, 0.02F * kRad);
    if (rings.size() < kEnough || steps.size() < kEnough) return {};
    found = {quantile(rings, 0.75), quantile(steps, 0.5)};
    if (are_alike(steps)) return found;
  }
  // Several sensors in one cloud have uneven steps, too; but theirs explain how many returns there are.
  const float mean_rad = mean_spacing_rad(scan);
  if (found.ring_spacing_rad * found.azimuth_step_rad < kMoreThanAReturnHas * mean_rad * mean_rad)
    return found;
  return {mean_rad, mean_rad};
}

}  // namespace

SensorGeometry measure_geometry(const ProjectedScan& scan) {
  const SensorGeometry found = measure(scan, 4);
  return found.ring_spacing_rad > 0 ? found : measure(scan, 1);
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
