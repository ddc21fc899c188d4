#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

#include "stillmap/types.hpp"

namespace stillmap {

/// atan2 to within 4e-6 rad without a branch on the quadrant's boundaries; 0 for (0, 0).
inline float fast_atan2(float y, float x) {
  constexpr float kPi = 3.14159265358979F;
  const float ax = std::abs(x), ay = std::abs(y);
  const float high = std::max(ax, ay), low = std::min(ax, ay);
  const float t = high > 0 ? low / high : 0.0F;
  const float s = t * t;
  // Odd minimax polynomial of atan on [0, 1].
  float a =
      ((((-0.013480470F * s + 0.057477314F) * s - 0.121239071F) * s + 0.195635925F) * s - 0.332994597F) * s +
      0.999995630F;
  a *= t;
  a = ay > ax ? 0.5F * kPi - a : a;
  a = x < 0 ? kPi - a : a;
  return y < 0 ? -a : a;
}

/// A direction and distance seen from the sensor: azimuth in [-pi, pi] from x to y, elevation in [-pi/2,
/// pi/2].
struct Spherical {
  float azimuth_rad, elevation_rad, range_m;
};
inline Spherical spherical(const Eigen::Vector3f& point_sensor_m) {
  const float flat =
      std::sqrt(point_sensor_m.x() * point_sensor_m.x() + point_sensor_m.y() * point_sensor_m.y());
  return {fast_atan2(point_sensor_m.y(), point_sensor_m.x()), fast_atan2(point_sensor_m.z(), flat),
          std::sqrt(flat * flat + point_sensor_m.z() * point_sensor_m.z())};
}

/// spherical() of n points at once, in vector registers: x, y, z in, the rest out.
void spherical(std::size_t n, const float* x, const float* y, const float* z, float* azimuth_rad,
               float* elevation_rad, float* range_m);

/// A scan one coordinate after the other, Cartesian and spherical; row i belongs to row i of the scan.
struct ProjectedScan {
  std::vector<float> x_m, y_m, z_m;                    ///< sensor frame
  std::vector<float> azimuth_rad, elevation_rad;       ///< 0 where there is no usable return
  std::vector<float> range_m;                          ///< 0: no usable return; -1: farther than max_range_m
  float elevation_min_rad = 0, elevation_max_rad = 0;  ///< over the judged rows
  std::size_t judged = 0;                              ///< rows with range > 0

  std::size_t size() const { return range_m.size(); }
};

/// Projects every row with min_range_m <= range <= max_range_m.
void project(const Scan& scan, float min_range_m, float max_range_m, ProjectedScan& projected);

}  // namespace stillmap
