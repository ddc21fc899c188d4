#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::replay_history(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  for (const NewVoxel& born : new_voxels) {
    Voxel& voxel = map.block(born.voxel.block).at(static_cast<int>(born.voxel.place));
    const Eigen::Vector3d point_map_m = T_map_sensor * scan.points[born.row].cast<double>();
    float log_odds = 0;
    static const float W = getenv("W2") ? atof(getenv("W2")) : 1; static const int NR = getenv("NR2") ? atoi(getenv("NR2")) : 1; static const int NN = getenv("NN2") ? atoi(getenv("NN2")) : 1;
    int found=0;
    if (W<1) { const VoxelKey me = voxel_key(map.block(born.voxel.block).key(), born.voxel.place);
        for (int dz=-NR; dz<=NR; dz++) for (int dy=-NR; dy<=NR ; dy++) for (int dx=-NR; dx<=NR; dx++) {
          const Voxel* o = map.find(me + VoxelKey(dx,dy,dz)); if (!o || o==&voxel) continue;
          if (o->hits>=3 && o->log_odds()>0.847f) found++; } }
    history.for_each([&](const ScanView& earlier) {
      const FusedEvidence evidence = earlier.evidence(earlier.to_sensor(point_map_m), models);
      if (evidence.kind() == Evidence::kUnknown) return;
      const auto age = static_cast<int>(scan_count - earlier.scan_index);
      if (evidence.kind() == Evidence::kSupport && age < parameters.replay_support_min_age) return;
      log_odds = recursion(log_odds, (evidence.kind() == Evidence::kConflict && found>=NN ? W : 1) * evidence.increment(log_odds));
    });
    if (parameters.hit_is_support) {
      FusedEvidence hit;
      for (const LevelModel& model : models) hit.support(model);
      log_odds = recursion(log_odds, hit.increment(log_odds));
    }
    voxel.set_log_odds(log_odds);
  }
}

}  // namespace stillmap
