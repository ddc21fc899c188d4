#pragma once

#include <string>

#include "stillmap/map_snapshot.hpp"

namespace stillmap {

/// Draws the map from above as .png: each column's highest static voxel, coloured by its height from blue
/// (low) to yellow (high) and shaded from the north-west. Returns what the picture shows, in words. Throws
/// std::invalid_argument when no voxel is static.
std::string save_height_picture(const MapSnapshot& map, const std::string& path);

}  // namespace stillmap
