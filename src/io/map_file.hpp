#pragma once

#include <string>

#include "stillmap/map_snapshot.hpp"

namespace stillmap {

/// Saves the map, atomically, in the format that the extension names: .pcd, .ply, .bt or .ot. Throws
/// std::runtime_error when it is another, or when the file cannot be written.
void save_map(const MapSnapshot& map, const std::string& path);

}  // namespace stillmap
