#include "io/map_file.hpp"

#include <filesystem>
#include <stdexcept>

#include "io/map_archive.hpp"
#include "io/octomap_file.hpp"
#include "io/point_cloud_file.hpp"

namespace stillmap {

void save_map(const MapPieces& map, const Decision& decision, const std::string& path) {
  if (std::filesystem::path(path).extension() == ".stillmap") return write_map_archive(map, path);
  save_map(snapshot_of(map, decision), path);
}

void save_map(const MapSnapshot& map, const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".pcd" || extension == ".ply") return save_point_cloud(map, path);
  if (extension == ".bt" || extension == ".ot") return save_octree(map, path);
  throw std::runtime_error(path + ": unknown map format '" + extension +
                           "'; give a path that ends in .pcd, .ply, .bt or .ot");
}

}  // namespace stillmap
