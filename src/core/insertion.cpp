#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::insert(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  const Eigen::Matrix3d R = T_map_sensor.linear() * map.inverse_voxel_size();
  const Eigen::Vector3d t = T_map_sensor.translation() * map.inverse_voxel_size();
  new_voxels.clear();
  hit_blocks.clear();
  voxel_of_row.assign(scan.points.size(), VoxelRef{});
  BlockKey last_key(0, 0, 0);
  std::uint32_t last_block = VoxelRef::kNone;  // neighbouring rows mostly share a block
  for (std::size_t row = 0; row < scan.points.size(); ++row) {
    if (!(projected.range_m[row] > 0)) continue;
    const Eigen::Vector3d point = R * scan.points[row].cast<double>() + t;  // in voxel edges
    const Eigen::Vector3d corner = point.array().floor();
    if ((corner.array().abs() >= kVoxelKeyLimit).any()) continue;
    const VoxelKey key = corner.cast<int>();
    const BlockKey block = block_key(key);
    if (last_block == VoxelRef::kNone || block != last_key) {
      last_block = enter_block(block);
      last_key = block;
    }
    const int place = place_in_block(key);
    bool created = false;
    Voxel& voxel = map.block(last_block).find_or_create(place, created);
    voxel.hit((point - corner).cast<float>());
    voxel_of_row[row] = {last_block, static_cast<std::uint32_t>(place)};
    if (created) new_voxels.push_back({voxel_of_row[row], static_cast<std::uint32_t>(row)});
  }
}

std::uint32_t Mapper::State::enter_block(const BlockKey& key) {
  const std::uint32_t index = map.find_or_create_block(key);
  VoxelBlock& block = map.block(index);
  if (block.hit_scan != scan_count) {
    block.age(scan_count);
    block.hit_scan = scan_count;
    hit_blocks.push_back(index);
  }
  return index;
}

}  // namespace stillmap
