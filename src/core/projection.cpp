#include "stillmap/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "for_rows.hpp"
#include "vector_clones.hpp"

namespace stillmap {

STILLMAP_VECTOR_CLONES void spherical(std::size_t n, const float* __restrict x, const float* __restrict y,
                                      const float* __restrict z, float* __restrict azimuth_rad,
                                      float* __restrict elevation_rad, float* __restrict range_m) {
  for (std::size_t i = 0; i < n; ++i) {
    const float flat_squared = x[i] * x[i] + y[i] * y[i];
    range_m[i] = std::sqrt(flat_squared + z[i] * z[i]);
    azimuth_rad[i] = fast_atan2(y[i], x[i]);
    elevation_rad[i] = fast_atan2(z[i], std::sqrt(flat_squared));
  }
}

namespace {

/// spherical() of rows first .. last - 1 of the scan, and which of them are usable.
STILLMAP_VECTOR_CLONES void project_rows(std::size_t first, std::size_t last, float min_range_m,
                                         float max_range_m, const float* __restrict x,
                                         const float* __restrict y, const float* __restrict z,
                                         float* __restrict azimuth_rad, float* __restrict elevation_rad,
                                         float* __restrict range_m) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  for (std::size_t i = first; i < last; ++i) {
    const float flat = std::sqrt(x[i] * x[i] + y[i] * y[i]);
    const float range = std::sqrt(flat * flat + z[i] * z[i]);
    const float azimuth = fast_atan2(y[i], x[i]), elevation = fast_atan2(z[i], flat);
    const bool usable = (range >= min_range_m) & (range <= max_range_m) & (range > 0);  // false for NaN
    const bool too_far = (range > max_range_m) & (range <= kLargest);
    range_m[i] = usable ? range : too_far ? -1.0F : 0.0F;
    azimuth_rad[i] = usable ? azimuth : 0.0F;
    elevation_rad[i] = usable ? elevation : 0.0F;
  }
}

/// Each lane of a vector register keeps an extent of its own.
STILLMAP_VECTOR_CLONES void note_extent(ProjectedScan& projected) {
  constexpr std::size_t kLanes = 16;
  const std::size_t n = projected.size();
  const float* const range_m = projected.range_m.data();
  const float* const elevation_rad = projected.elevation_rad.data();
  float lowest[kLanes], highest[kLanes];
  int judged[kLanes] = {};
  std::fill_n(lowest, kLanes, 2.0F);
  std::fill_n(highest, kLanes, -2.0F);
  const auto note = [&](std::size_t row, std::size_t lane) {
    const bool usable = range_m[row] > 0;
    const float elevation = elevation_rad[row];
    lowest[lane] = std::min(lowest[lane], usable ? elevation : 2.0F);
    highest[lane] = std::max(highest[lane], usable ? elevation : -2.0F);
    judged[lane] += usable ? 1 : 0;
  };
  std::size_t row = 0;
  for (; row + kLanes <= n; row += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) note(row + lane, lane);
  for (; row < n; ++row) note(row, 0);
  projected.judged = static_cast<std::size_t>(std::accumulate(judged, judged + kLanes, 0));
  const bool any = projected.judged > 0;
  projected.elevation_min_rad = any ? *std::min_element(lowest, lowest + kLanes) : 0.0F;
  projected.elevation_max_rad = any ? *std::max_element(highest, highest + kLanes) : 0.0F;
}

}  // namespace

void project(const Scan& scan, float min_range_m, float max_range_m, ProjectedScan& projected) {
  const std::size_t n = scan.points.size();
  for (std::vector<float>* column : {&projected.x_m, &projected.y_m, &projected.z_m, &projected.azimuth_rad,
                                     &projected.elevation_rad, &projected.range_m})
    column->resize(n);
  ProjectedScan& p = projected;
  for_rows(n, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      p.x_m[i] = scan.points[i].x();
      p.y_m[i] = scan.points[i].y();
      p.z_m[i] = scan.points[i].z();
    }
    project_rows(first, last, min_range_m, max_range_m, p.x_m.data(), p.y_m.data(), p.z_m.data(),
                 p.azimuth_rad.data(), p.elevation_rad.data(), p.range_m.data());
  });
  note_extent(projected);
}

}  // namespace stillmap
