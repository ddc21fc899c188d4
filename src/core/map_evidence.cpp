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
      float weaken=1; static const int H = getenv("H") ? atoi(getenv("H")) : 1;
      static const float W = getenv("W") ? atof(getenv("W")) : .15; static const int NR = getenv("NR") ? atoi(getenv("NR")) : 2;
      if (evidence.kind() == Evidence::kConflict && W < 1) {
        const VoxelKey me = voxel_key(block.key(), place);
        for (int dz=-NR; dz<=NR && weaken==1; dz++) for (int dy=-NR; dy<=NR && weaken==1; dy++) for (int dx=-NR; dx<=NR; dx++) {
          const Voxel* o = map.find(me + VoxelKey(dx,dy,dz)); if (!o || o==&voxel) continue;
          if (o->idle==0 && o->hits>=3 && o->log_odds()>0.847f) { weaken=W; break; } }
      }
      if (evidence.kind() == Evidence::kConflict) voxel.conflicts = voxel.conflicts < 127 ? voxel.conflicts+1 : voxel.conflicts;
      voxel.set_log_odds(recursion(voxel.log_odds(), weaken*((H && hit && (voxel.conflicts&0x80)) ? 0.8f*(1-p_from_log_odds(voxel.log_odds())) : evidence.increment(voxel.log_odds()))));
    });
  }
}

}  // namespace stillmap
