#include "maps/export_map.hpp"

#include <filesystem>
#include <stdexcept>

#include "io/map_file.hpp"
#include "maps/height_picture.hpp"

namespace stillmap {

std::string export_map(const MapContents& map, const Decision& decision, const std::string& path) {
  const MapSnapshot snapshot = snapshot_of(pieces_of(map), decision);
  if (std::filesystem::path(path).extension() == ".png")
    return path + ": " + save_height_picture(snapshot, path);
  save_map(pieces_of(map), decision, path);
  std::size_t static_voxels = 0;
  for (const SnapshotVoxel& voxel : snapshot.voxels) static_voxels += voxel.label == Label::kStatic;
  return path + ": " + std::to_string(static_voxels) + " static of " +
         std::to_string(snapshot.voxels.size()) + " voxels";
}

}  // namespace stillmap
