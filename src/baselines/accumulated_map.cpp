#include "baselines/accumulated_map.hpp"

#include "baselines/removal_method.hpp"

namespace stillmap {

void AccumulatedMap::add(const Frame& frame) {
  std::vector<std::uint32_t>& point_of_row = point_of_row_.emplace_back(frame.scan.points.size(), kNone);
  for (std::size_t row = 0; row < point_of_row.size(); ++row) {
    if (!is_return(frame.scan.points[row])) continue;
    const Eigen::Vector3d point = frame.T_map_sensor * frame.scan.points[row].cast<double>();
    const VoxelKey key = voxels_.key_of(point);
    const std::uint64_t block = voxels_.find_or_create_block(block_key(key));
    const std::uint64_t voxel = block * kBlockVolume + static_cast<std::uint64_t>(place_in_block(key));
    const auto [entry, created] = index_.try_emplace(voxel, static_cast<std::uint32_t>(points_.size()));
    if (created) {
      points_.push_back(Eigen::Vector3d::Zero());
      returns_.push_back(0);
    }
    const std::uint32_t index = entry->second;
    points_[index] += (point - points_[index]) / ++returns_[index];
    point_of_row[row] = index;
  }
}

}  // namespace stillmap
