#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "stillmap/projection.hpp"
#include "stillmap/voxel_key.hpp"

namespace stillmap {

/// The voxel that each row of a scan lies in, and where in it.
struct LocatedRows {
  static constexpr std::uint64_t kNowhere = ~std::uint64_t{0};

  std::vector<std::uint64_t> block;  ///< packed key; kNowhere: not judged, or beyond the map's limits
  std::vector<std::uint16_t> place;  ///< in the block
  std::vector<float> x, y, z;        ///< from the voxel's low corner, in voxel edges

  void locate(const ProjectedScan& scan, const Eigen::Isometry3d& T_map_sensor, double inverse_voxel_size);
  Eigen::Vector3f offset(std::size_t row) const { return {x[row], y[row], z[row]}; }
};

}  // namespace stillmap
