#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::replay_history(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  for (const NewVoxel& born : new_voxels) {
    Voxel& voxel = map.block(born.voxel.block).at(static_cast<int>(born.voxel.place));
    const Eigen::Vector3d point_map_m = T_map_sensor * scan.points[born.row].cast<double>();
    float log_odds = 0;
    history.for_each([&](const ScanView& earlier) {
      const FusedEvidence evidence = earlier.evidence(earlier.to_sensor(point_map_m), models);
      if (evidence.kind() == Evidence::kUnknown) return;
      const auto age = static_cast<int>(scan_count - earlier.scan_index);
      if (evidence.kind() == Evidence::kSupport && age < parameters.replay_support_min_age) return;
      log_odds = recursion(log_odds, evidence.increment(log_odds));
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
