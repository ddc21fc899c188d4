#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "stillmap/projection.hpp"

namespace stillmap {

constexpr float kRad = 0.01745329252F;

/// Range in a direction; 0 = no return.
using RangeOf = std::function<float(float azimuth_rad, float elevation_rad)>;

inline Eigen::Vector3f direction(float azimuth_rad, float elevation_rad) {
  return {std::cos(elevation_rad) * std::cos(azimuth_rad), std::cos(elevation_rad) * std::sin(azimuth_rad),
          std::sin(elevation_rad)};
}

/// Rings from lowest_deg to highest_deg, `columns` returns in each, a ring after the other.
struct Rings {
  int rings, columns;
  float lowest_deg, highest_deg;

  float spacing_deg() const { return (highest_deg - lowest_deg) / static_cast<float>(rings - 1); }
  float step_deg() const { return 360.0F / static_cast<float>(columns); }
  Scan scan(const RangeOf& range_of) const {
    Scan scan;
    for (int ring = 0; ring < rings; ++ring)
      for (int column = 0; column < columns; ++column) {
        const float azimuth = (static_cast<float>(column) * step_deg() - 179.9F) * kRad;
        const float elevation = (lowest_deg + static_cast<float>(ring) * spacing_deg()) * kRad;
        scan.points.emplace_back(range_of(azimuth, elevation) * direction(azimuth, elevation));
      }
    return scan;
  }
};

/// Level ground `height_m` below the sensor, inside a round wall.
inline RangeOf ground_and_wall(float height_m, float wall_m) {
  return [=](float, float elevation_rad) {
    const float wall = wall_m / std::cos(elevation_rad);
    return elevation_rad < 0 ? std::min(wall, height_m / std::sin(-elevation_rad)) : wall;
  };
}

inline ProjectedScan projected(const Scan& scan) {
  ProjectedScan result;
  project(scan, 0.4F, 100.0F, result);
  return result;
}

}  // namespace stillmap
