#pragma once

#include <Eigen/Core>
#include <vector>

#include "scan_view.hpp"

namespace stillmap {

/// Points of the map, one coordinate after the other, and where the scan that was last asked sees them.
struct MapPoints {
  std::vector<double> x_map_m, y_map_m, z_map_m;
  std::vector<float> azimuth_rad, elevation_rad, range_m;

  std::size_t size() const { return x_map_m.size(); }
  void reserve(std::size_t points);
  void add(const Eigen::Vector3d& point_map_m);
  Eigen::Vector3d operator[](std::size_t i) const { return {x_map_m[i], y_map_m[i], z_map_m[i]}; }
  /// All at once, in vector registers.
  void see_from(const ScanView& scan);
};

}  // namespace stillmap
