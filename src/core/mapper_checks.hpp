#pragma once

#include <Eigen/Geometry>

#include "stillmap/parameters.hpp"

namespace stillmap {

// What a mapper is given, before it changes anything: each throws std::invalid_argument that says what is
// wrong.
void require_valid(const Parameters& parameters);
/// Finite, rigid, and within the reach of a map of this voxel size.
void require_usable(const Eigen::Isometry3d& T_map_sensor, double voxel_size_m);
void require_sensor(int sensor);

}  // namespace stillmap
