#include "stillmap/projection.hpp"

#include <algorithm>
#include <cmath>

namespace stillmap {

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
