#pragma once

#include <string>

#include "stillmap/map_contents.hpp"

namespace stillmap {

/// Saves the map, atomically, in the format that the extension names: .stillmap with its complete state,
/// .pcd, .ply, .bt or .ot with what `decision` says of each voxel. Throws std::runtime_error when it is
/// another, or when the file cannot be written.
void save_map(const MapPieces& map, const Decision& decision, const std::string& path);

/// The same for a snapshot, which cannot become a .stillmap.
void save_map(const MapSnapshot& map, const std::string& path);

}  // namespace stillmap
