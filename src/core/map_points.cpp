#include "map_points.hpp"

#include <cmath>

#include "stillmap/projection.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// ScanView::to_sensor() and spherical() of n points.
// NOLINTNEXTLINE(performance-unnecessary-value-param): copies stay in registers
STILLMAP_VECTOR_CLONES void see(const Eigen::Vector3d origin, const Eigen::Matrix3f R, std::size_t n,
                                const double* __restrict x_map_m, const double* __restrict y_map_m,
                                const double* __restrict z_map_m, float* __restrict azimuth_rad,
                                float* __restrict elevation_rad, float* __restrict range_m) {
  const double x0 = origin.x(), y0 = origin.y(), z0 = origin.z();
  for (std::size_t i = 0; i < n; ++i) {
    const auto dx = static_cast<float>(x_map_m[i] - x0);
    const auto dy = static_cast<float>(y_map_m[i] - y0);
    const auto dz = static_cast<float>(z_map_m[i] - z0);
    const float x = R(0, 0) * dx + (R(0, 1) * dy + R(0, 2) * dz);
    const float y = R(1, 0) * dx + (R(1, 1) * dy + R(1, 2) * dz);
    const float z = R(2, 0) * dx + (R(2, 1) * dy + R(2, 2) * dz);
    const float flat = std::sqrt(x * x + y * y);
    azimuth_rad[i] = fast_atan2(y, x);
    elevation_rad[i] = fast_atan2(z, flat);
    range_m[i] = std::sqrt(flat * flat + z * z);
  }
}

}  // namespace

void MapPoints::reserve(std::size_t points) {
  for (std::vector<double>* axis : {&x_map_m, &y_map_m, &z_map_m}) axis->reserve(points);
}

void MapPoints::add(const Eigen::Vector3d& point_map_m) {
  x_map_m.push_back(point_map_m.x());
  y_map_m.push_back(point_map_m.y());
  z_map_m.push_back(point_map_m.z());
}

void MapPoints::see_from(const ScanView& scan) {
  for (std::vector<float>* seen : {&azimuth_rad, &elevation_rad, &range_m}) seen->resize(size());
  see(scan.origin_map_m, scan.R_sensor_map, size(), x_map_m.data(), y_map_m.data(), z_map_m.data(),
      azimuth_rad.data(), elevation_rad.data(), range_m.data());
}

}  // namespace stillmap
