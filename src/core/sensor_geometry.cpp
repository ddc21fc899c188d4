#include "stillmap/sensor_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "vector_clones.hpp"

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

  static constexpr float kHalfTurn = 3.15F;  // no angle is larger
  int first() const { return static_cast<int>(std::floor(-kHalfTurn / width_rad)); }
  std::size_t count() const { return static_cast<std::size_t>(2 - 2 * first()); }
};

constexpr std::size_t kAtOnce = 512;
constexpr int kNoBin = -1;

/// The bin of each of n rows; none for those without a return and where a bin is not looked at. These lie
/// scattered, so that neither rings at even distances nor a narrow field of view fall between the others.
STILLMAP_VECTOR_CLONES void find_bins(std::size_t n, const float* __restrict angle_rad,
                                      const float* __restrict range_m, const Bins& of_bins,
                                      int* __restrict bin) {
  const Bins bins = of_bins;
  const int first = bins.first();
  const auto looked_at = static_cast<int>(65536U / bins.of);
  for (std::size_t i = 0; i < n; ++i) {
    const float at = angle_rad[i] / bins.width_rad + bins.shift;
    const int whole = static_cast<int>(at);
    const int found = whole - (at < static_cast<float>(whole) ? 1 : 0) - first;  // std::floor is a call
    const auto scattered = static_cast<int>((static_cast<std::uint32_t>(found) * 2654435769U) >> 16);
    const bool counts = (range_m[i] > 0) & (scattered < looked_at);
    bin[i] = counts ? found : kNoBin;
  }
}

/// Sorts `angle` inside bins of `bin_angle` and returns the gaps between neighbours that are at least
/// `floor_rad`.
std::vector<float> gaps_inside_bins(const std::vector<float>& bin_angle, const std::vector<float>& angle,
                                    const std::vector<float>& range_m, Bins bins, float floor_rad) {
  struct Row {
    int bin;
    float angle_rad;
  };
  std::vector<Row> rows(angle.size() + 1);
  std::vector<std::uint32_t> end(bins.count() + 1, 0);  // of each bin; first, how many the bin before has
  std::size_t count = 0;
  int bin[kAtOnce];
  for (std::size_t first = 0; first < angle.size(); first += kAtOnce) {
    const std::size_t n = std::min(kAtOnce, angle.size() - first);
    find_bins(n, &bin_angle[first], &range_m[first], bins, bin);
    for (std::size_t i = 0; i < n; ++i) {
      rows[count] = {bin[i], angle[first + i]};
      count += bin[i] != kNoBin ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < count; ++i) ++end[static_cast<std::size_t>(rows[i].bin) + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<float> sorted(count), gaps;
  for (std::size_t i = 0; i < count; ++i)
    sorted[end[static_cast<std::size_t>(rows[i].bin)]++] = rows[i].angle_rad;
  for (std::size_t b = 0, first = 0; b < bins.count(); first = end[b++]) {
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(first), sorted.begin() + end[b]);
    for (std::size_t i = first + 1; i < end[b]; ++i)
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
