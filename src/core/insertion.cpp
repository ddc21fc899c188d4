#include "mapper_state.hpp"

namespace stillmap {
namespace {

void count_up(std::uint8_t& counter) {
  if (counter < 0xFF) ++counter;
}

void age(VoxelBlock& block, std::uint32_t scan) {
  const std::uint32_t scans = scan - block.last_visit;
  if (scans == 0) return;
  block.last_visit = scan;
  block.for_each([scans](int, Voxel& voxel) {
    voxel.idle = static_cast<std::uint8_t>(std::min(255U, voxel.idle + scans));
    voxel.first_seen = static_cast<std::uint8_t>(std::min(255U, voxel.first_seen + scans));
  });
}

}  // namespace

void Mapper::State::insert(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  const Eigen::Matrix3d R = T_map_sensor.linear();
  const Eigen::Vector3d t = T_map_sensor.translation();
  new_voxels.clear();
  hit_blocks.clear();
  voxel_of_row.assign(scan.points.size(), VoxelRef{});
  BlockKey last_key(0, 0, 0);
  std::uint32_t last_block = VoxelRef::kNone;  // neighbouring rows mostly share a block
  for (std::size_t row = 0; row < scan.points.size(); ++row) {
    if (!(projected.range_m[row] > 0)) continue;
    const Eigen::Vector3d point = (R * scan.points[row].cast<double>() + t) * map.inverse_voxel_size();
    const Eigen::Vector3d corner = point.array().floor();
    const VoxelKey key = corner.cast<int>();
    if ((key.array().abs() >= kVoxelKeyLimit).any()) continue;
    const BlockKey block = block_key(key);
    if (last_block == VoxelRef::kNone || block != last_key) {
      last_block = map.find_or_create_block(block);
      last_key = block;
      age(map.block(last_block), scan_count);
      if (map.block(last_block).last_hit != scan_count) hit_blocks.push_back(last_block);
      map.block(last_block).last_hit = scan_count;
    }
    const int place = place_in_block(key);
    bool created = false;
    Voxel& voxel = map.block(last_block).find_or_create(place, created);
    voxel_of_row[row] = {last_block, static_cast<std::uint32_t>(place)};
    if (created) new_voxels.push_back({voxel_of_row[row], static_cast<std::uint32_t>(row)});
    if (created || voxel.idle > 0) count_up(voxel.hits);
    if (!created && voxel.idle > 0) voxel.conflicts = (voxel.conflicts & 0x7f) > 0 && voxel.idle >= 2 ? (0x80|voxel.conflicts) : (voxel.conflicts & 0x7f);
    voxel.idle = 0;
    voxel.move_surface((point - corner).cast<float>(), created ? 1.0F : 0.25F);
  }
}

}  // namespace stillmap
