#pragma once

#include <string>

#include "stillmap/map_snapshot.hpp"

namespace stillmap {

/// Saves the static voxels' centres, with p_static as intensity, as binary .pcd or .ply, atomically.
void save_point_cloud(const MapSnapshot& map, const std::string& path);

}  // namespace stillmap
