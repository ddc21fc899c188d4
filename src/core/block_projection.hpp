#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "scan_view.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// Voxels of one block as a scan sees them: where their surfaces lie, and about which of them it tells.
class BlockProjection {
 public:
  void add(int place, Voxel& voxel) {
    packed_[size_] = static_cast<std::uint32_t>(place) << 15 | voxel.surface;
    voxels_[size_++] = &voxel;
  }
  std::size_t size() const { return size_; }

  /// `corner_sensor_m` is the block's low corner.
  void project(const Eigen::Vector3f& corner_sensor_m, const ScanView& view, float voxel_m);
  /// Calls visit(place, voxel, spherical) for each voxel that the scan supports or contradicts.
  template <class Visitor>
  void for_each_told(const ScanView& view, const std::vector<LevelModel>& models, Visitor&& visit) {
    view.find_told(size_, azimuth_rad_, elevation_rad_, range_m_, models, told_);
    for (std::size_t i = 0; i < size_; ++i)
      if (told_[i] != 0)
        visit(static_cast<int>(packed_[i] >> 15), *voxels_[i],
              Spherical{azimuth_rad_[i], elevation_rad_[i], range_m_[i]});
  }

 private:
  std::size_t size_ = 0;
  std::uint32_t packed_[kBlockVolume];  ///< place and surface
  Voxel* voxels_[kBlockVolume];
  float x_[kBlockVolume], y_[kBlockVolume], z_[kBlockVolume];
  float azimuth_rad_[kBlockVolume], elevation_rad_[kBlockVolume], range_m_[kBlockVolume];
  std::uint8_t told_[kBlockVolume];
};

}  // namespace stillmap
