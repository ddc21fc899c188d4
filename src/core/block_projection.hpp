#pragma once

#include "scan_view.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// The surface of each voxel of a block as a scan sees it, in the block's own order.
class BlockProjection {
 public:
  /// `corner_sensor_m` is the block's low corner.
  void project(const VoxelBlock& block, const Eigen::Vector3f& corner_sensor_m, const ScanView& view,
               float voxel_m) {
    constexpr int mask = kBlockEdge - 1;
    std::size_t n = 0;
    block.for_each([&](int place, const Voxel& voxel) {
      const Eigen::Vector3f offset = voxel.surface_offset();
      x_[n] = static_cast<float>(place & mask) + offset.x();
      y_[n] = static_cast<float>(place >> kBlockShift & mask) + offset.y();
      z_[n] = static_cast<float>(place >> (2 * kBlockShift)) + offset.z();
      ++n;
    });
    const Eigen::Matrix3f step = view.R_sensor_map * voxel_m;
    for (std::size_t i = 0; i < n; ++i) {
      const float u = x_[i], v = y_[i], w = z_[i];
      x_[i] = corner_sensor_m.x() + step(0, 0) * u + step(0, 1) * v + step(0, 2) * w;
      y_[i] = corner_sensor_m.y() + step(1, 0) * u + step(1, 1) * v + step(1, 2) * w;
      z_[i] = corner_sensor_m.z() + step(2, 0) * u + step(2, 1) * v + step(2, 2) * w;
    }
    spherical(n, x_, y_, z_, azimuth_rad_, elevation_rad_, range_m_);
  }
  Spherical operator[](std::size_t i) const { return {azimuth_rad_[i], elevation_rad_[i], range_m_[i]}; }

 private:
  float x_[kBlockVolume], y_[kBlockVolume], z_[kBlockVolume];
  float azimuth_rad_[kBlockVolume], elevation_rad_[kBlockVolume], range_m_[kBlockVolume];
};

}  // namespace stillmap
