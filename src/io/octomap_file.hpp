#pragma once

#include <memory>
#include <string>

#include "stillmap/map_snapshot.hpp"

namespace octomap {
class OcTree;
}

namespace stillmap {

/// Static voxels are occupied and dynamic ones free, with their log-odds clamped to OctoMap's bounds;
/// uncertain ones stay unknown. Throws std::runtime_error when the map is wider than OctoMap's 16-bit keys.
std::unique_ptr<octomap::OcTree> to_octree(const MapSnapshot& map);

/// Saves it atomically as .bt (occupied or free) or .ot (with log-odds).
void save_octree(const MapSnapshot& map, const std::string& path);

}  // namespace stillmap
