#include "io/octomap_file.hpp"

#include <octomap/OcTree.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "io/atomic_file.hpp"

namespace stillmap {

std::unique_ptr<octomap::OcTree> to_octree(const MapSnapshot& map) {
  auto tree = std::make_unique<octomap::OcTree>(map.voxel_size_m);
  const bool inner_nodes_later = true;
  for (const SnapshotVoxel& voxel : map.voxels) {
    if (voxel.label == Label::kUncertain) continue;
    octomap::OcTreeKey key;
    const octomap::point3d center(voxel.center.x(), voxel.center.y(), voxel.center.z());
    if (!tree->coordToKeyChecked(center, key))
      throw std::runtime_error(
          "OctoMap holds 32768 voxels on each side of the map's origin (" +
          std::to_string(32768 * map.voxel_size_m) +
          " m at this voxel_size_m) and the map reaches farther; save it as .pcd or .ply");
    tree->setNodeValue(
        key, std::clamp(voxel.log_odds, tree->getClampingThresMinLog(), tree->getClampingThresMaxLog()),
        inner_nodes_later);
  }
  tree->updateInnerOccupancy();
  return tree;
}

void save_octree(const MapSnapshot& map, const std::string& path) {
  const std::unique_ptr<octomap::OcTree> tree = to_octree(map);
  const bool binary = std::filesystem::path(path).extension() == ".bt";
  write_atomically(path, [&](const std::string& file) {
    std::ofstream stream(file, std::ios::binary);  // of our own: OctoMap's is closed without a look
    const bool is_written = binary ? tree->writeBinary(stream) : tree->write(stream);
    if (!is_written || !stream.flush())
      throw std::runtime_error(path + ": cannot be written; is the folder writable and the disk not full?");
  });
}

}  // namespace stillmap
