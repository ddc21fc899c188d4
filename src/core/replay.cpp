#include <tbb/parallel_for.h>

#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::replay_history(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  tbb::parallel_for(std::size_t{0}, new_voxels.size(), [&](std::size_t i) {
    const std::uint32_t row = new_voxels[i];
    float log_odds = replayed_log_odds(voxel_of_row[row], T_map_sensor * scan.points[row].cast<double>());
    if (parameters.hit_is_support) log_odds = recursion(log_odds, own_hit.increment(log_odds));
    voxel_of(voxel_of_row[row]).set_log_odds(log_odds);
  });
}

float Mapper::State::replayed_log_odds(const VoxelRef& voxel, const Eigen::Vector3d& point_map_m) const {
  float log_odds = 0;
  float conflict_factor = 0;  // looked up at the first conflict
  history.for_each([&](const ScanView& earlier) {
    const FusedEvidence evidence = earlier.evidence(earlier.to_sensor(point_map_m), models);
    if (evidence.kind() == Evidence::kUnknown) return;
    // What moves slowly was nearly here a moment ago: only older scans speak for the surface.
    const auto age = static_cast<int>(scan_count - earlier.scan_index);
    const bool support = evidence.kind() == Evidence::kSupport;
    if (support && age < parameters.replay_support_min_age) return;
    if (!support && conflict_factor <= 0) conflict_factor = replay_conflict_factor(voxel);
    log_odds = recursion(log_odds, (support ? 1.0F : conflict_factor) * evidence.increment(log_odds));
  });
  return log_odds;
}

float Mapper::State::replay_conflict_factor(const VoxelRef& voxel) const {
  const CellMask porous = near_porous(map.block(voxel.block).key());
  const bool beside = (porous & cell_bit(static_cast<int>(voxel.place))) != 0;
  return beside ? static_cast<float>(parameters.conflict_porous) : 1.0F;
}

}  // namespace stillmap
