#include <tbb/parallel_for.h>

#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::replay_history(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  const auto porous_conflict = static_cast<float>(parameters.conflict_porous);
  tbb::parallel_for(std::size_t{0}, new_voxels.size(), [&](std::size_t i) {
    const NewVoxel& born = new_voxels[i];
    VoxelBlock& block = map.block(born.voxel.block);
    const int place = static_cast<int>(born.voxel.place);
    const bool porous = (near_porous(block.key()) & cell_bit(place)) != 0;
    const Eigen::Vector3d point_map_m = T_map_sensor * scan.points[born.row].cast<double>();
    float log_odds = replayed_log_odds(point_map_m, porous ? porous_conflict : 1.0F);
    if (parameters.hit_is_support) log_odds = recursion(log_odds, own_hit().increment(log_odds));
    block.at(place).set_log_odds(log_odds);
  });
}

float Mapper::State::replayed_log_odds(const Eigen::Vector3d& point_map_m, float conflict_factor) const {
  float log_odds = 0;
  history.for_each([&](const ScanView& earlier) {
    const FusedEvidence evidence = earlier.evidence(earlier.to_sensor(point_map_m), models);
    if (evidence.kind() == Evidence::kUnknown) return;
    // What moves slowly was nearly here a moment ago: only older scans speak for the surface.
    const auto age = static_cast<int>(scan_count - earlier.scan_index);
    const bool support = evidence.kind() == Evidence::kSupport;
    if (support && age < parameters.replay_support_min_age) return;
    log_odds = recursion(log_odds, (support ? 1.0F : conflict_factor) * evidence.increment(log_odds));
  });
  return log_odds;
}

}  // namespace stillmap
