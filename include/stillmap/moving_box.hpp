#pragma once

#include <Eigen/Geometry>
#include <cstddef>

namespace stillmap {

/// An upright box around the returns of one thing that moves.
struct MovingBox {
  Eigen::Isometry3d T_map_box = Eigen::Isometry3d::Identity();  ///< from its middle; z up
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
  std::size_t points = 0;
};

}  // namespace stillmap
