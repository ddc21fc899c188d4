#include <tbb/parallel_for.h>

#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::apply_evidence(const ScanView& view) {
  find_known_surface();
  // Blocks own their voxels and read only what no other block writes: any order gives the same map.
  tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(map.block_count()),
                    [&](std::uint32_t index) { apply_evidence(view, map.block(index)); });
}

void Mapper::State::apply_evidence(const ScanView& view, VoxelBlock& block) {
  const auto voxel_m = static_cast<float>(map.voxel_size_m());
  const auto reach_m = static_cast<float>(parameters.max_range_m + 2 * map.block_size_m());
  const bool block_hit = block.hit_scan == scan_count;
  const Eigen::Vector3f corner =
      view.to_sensor(voxel_key(block.key(), 0).cast<double>() * map.voxel_size_m());
  if (corner.squaredNorm() > reach_m * reach_m) return;
  const auto half_m = static_cast<float>(0.5 * map.block_size_m());
  const Eigen::Vector3f center = corner + view.R_sensor_map * Eigen::Vector3f::Constant(half_m);
  if (!block_hit && view.hides_ball(center, half_m * std::sqrt(3.0F), models)) return;
  block.age(scan_count);
  const auto beside_surface = static_cast<float>(parameters.conflict_beside_surface);
  const auto porous = static_cast<float>(parameters.conflict_porous);
  CellMask surface = 0;
  bool surface_known = false;

  block.for_each([&](int place, Voxel& voxel) {
    if (voxel.age == 0) return;  // new: replay judges it
    const bool hit = block_hit && voxel.idle == 0;
    if (hit && parameters.hit_is_support) {
      const float log_odds = voxel.log_odds();
      const bool full = parameters.full_support_on_return && voxel.came_back;
      const float eta = full ? models.front().eta : own_hit().eta(log_odds);
      voxel.set_log_odds(recursion(log_odds, support_increment(eta, p_from_log_odds(log_odds))));
      return;
    }
    const Eigen::Vector3f low = voxel_key(BlockKey::Zero(), place).cast<float>();
    const Eigen::Vector3f surface_sensor_m =
        corner + view.R_sensor_map * ((low + voxel.surface_offset()) * voxel_m);
    const FusedEvidence evidence = view.evidence(surface_sensor_m, models);
    if (evidence.kind() == Evidence::kUnknown) return;
    float increment = evidence.increment(voxel.log_odds());
    if (evidence.kind() == Evidence::kConflict) {
      if (voxel.came_back != 0) increment *= porous;
      voxel.see_through();
      if (!surface_known) surface = near_standing_surface(block.key());
      surface_known = true;
      if ((surface & cell_bit(place)) != 0) increment *= beside_surface;
    }
    voxel.set_log_odds(recursion(voxel.log_odds(), increment));
  });
}

FusedEvidence Mapper::State::own_hit() const {
  FusedEvidence hit;
  for (const LevelModel& model : models) hit.support(model);
  return hit;
}

}  // namespace stillmap
