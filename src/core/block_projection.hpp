#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "scan_view.hpp"
#include "stillmap/cell_mask.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// The voxels of one block as a scan sees them: where their surfaces lie, and what it tells about them.
class BlockProjection {
 public:
  /// Which voxels of a block that the scan hit are asked about: those known before, those that it did not
  /// hit.
  enum class Asked { kAll, kKnown, kNotHit };
  /// `corner_sensor_m` is the block's low corner.
  void project(const VoxelBlock& block, Asked asked, const Eigen::Vector3f& corner_sensor_m,
               const ScanView& view, float voxel_m);
  /// Sorts out the voxels that the scan supports or contradicts.
  void find_told(const ScanView& view, const std::vector<LevelModel>& models);

  /// Calls visit(rank, says) for each voxel that it supports; see ScanView::find_told().
  template <class Visitor>
  void for_each_supported(Visitor&& visit) const {
    for (std::size_t k = 0; k < told_size_; ++k)
      if (const std::size_t i = told_at_[k]; told_[i] != ScanView::kConflict)
        visit(static_cast<int>(rank_[i]), told_[i]);
  }
  /// The cells of those that it contradicts.
  CellMask seen_through() const {
    CellMask cells = 0;
    for (std::size_t k = 0; k < told_size_; ++k)
      cells |= cell_bit(place(told_at_[k]), told_[told_at_[k]] == ScanView::kConflict);
    return cells;
  }
  /// Calls visit(place, rank, seen) for each of them.
  template <class Visitor>
  void for_each_contradicted(Visitor&& visit) const {
    for (std::size_t k = 0; k < told_size_; ++k)
      if (const std::size_t i = told_at_[k]; told_[i] == ScanView::kConflict)
        visit(place(i), static_cast<int>(rank_[i]),
              Spherical{azimuth_rad_[i], elevation_rad_[i], range_m_[i]});
  }

 private:
  static constexpr std::size_t kLanes = 8;  ///< vector registers are filled up with the voxel at place 0
  static constexpr std::size_t kMost = kBlockVolume + kLanes;

  int place(std::size_t i) const { return static_cast<int>(packed_[i] >> 15); }
  std::size_t whole_lanes() const { return (size_ + kLanes - 1) / kLanes * kLanes; }

  // One for each voxel that is asked about, by rank.
  std::size_t size_ = 0, told_size_ = 0;
  std::uint32_t packed_[kMost];  ///< place and surface
  std::uint16_t rank_[kMost];
  float azimuth_rad_[kMost], elevation_rad_[kMost], range_m_[kMost];
  int told_[kMost];
  std::uint16_t told_at_[kMost];  ///< the voxels about which the scan tells
};

}  // namespace stillmap
