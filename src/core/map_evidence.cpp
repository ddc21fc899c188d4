#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::apply_evidence(const ScanView& view) {
  const float reach = static_cast<float>(parameters.max_range_m + map.block_size_m());
  const float voxel_m = static_cast<float>(map.voxel_size_m());
  const Eigen::Matrix3f step = view.R_sensor_map * voxel_m;
  for (std::uint32_t index = 0; index < map.block_count(); ++index) {
    VoxelBlock& block = map.block(index);
    const Eigen::Vector3f first =
        view.to_sensor(voxel_key(block.key(), 0).cast<double>() * map.voxel_size_m());
    if (first.norm() > reach) continue;
    block.for_each([&](int place, Voxel& voxel) {
      const bool hit = block.last_hit == scan_count && voxel.idle == 0;
      FusedEvidence evidence;
      if (hit && parameters.hit_is_support) {
        for (const LevelModel& model : models) evidence.support(model);
      } else {
        const VoxelKey key = voxel_key(BlockKey(0, 0, 0), place);
        evidence = view.evidence(first + step * (key.cast<float>() + voxel.surface_offset()), models);
      }
      if (evidence.kind() == Evidence::kUnknown) return;
      if (evidence.kind() == Evidence::kConflict) voxel.conflicts = std::min(254, voxel.conflicts + 0) + 1;
      voxel.set_log_odds(recursion(voxel.log_odds(), evidence.increment(voxel.log_odds())));
    });
  }
}

}  // namespace stillmap
