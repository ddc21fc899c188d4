#include "stillmap/projection.hpp"

#include <algorithm>
#include <cmath>

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

void project(const Scan& scan, float min_range_m, float max_range_m, ProjectedScan& projected) {
  const std::size_t n = scan.points.size();
  projected.azimuth_rad.resize(n);
  projected.elevation_rad.resize(n);
  projected.range_m.resize(n);
  float lowest = 2.0F, highest = -2.0F;
  std::size_t judged = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Spherical s = spherical(scan.points[i]);
    const bool usable =
        s.range_m >= min_range_m && s.range_m <= max_range_m && s.range_m > 0;  // false for NaN
    projected.azimuth_rad[i] = s.azimuth_rad;
    projected.elevation_rad[i] = s.elevation_rad;
    const bool too_far = s.range_m > max_range_m && std::isfinite(s.range_m);
    projected.range_m[i] = usable ? s.range_m : too_far ? -1.0F : 0.0F;
    lowest = usable ? std::min(lowest, s.elevation_rad) : lowest;
    highest = usable ? std::max(highest, s.elevation_rad) : highest;
    judged += usable;
  }
  projected.judged = judged;
  projected.elevation_min_rad = judged > 0 ? lowest : 0.0F;
  projected.elevation_max_rad = judged > 0 ? highest : 0.0F;
}

}  // namespace stillmap
