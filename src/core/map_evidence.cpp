#include <tbb/parallel_for.h>

#include "block_projection.hpp"
#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::apply_evidence(const ScanView& view) {
  find_known_surface();
  map.find_near(view.origin_map_m, reach_m(), near_blocks);
  // Blocks own their voxels and read only what no other block writes: any order gives the same map.
  tbb::parallel_for(std::size_t{0}, near_blocks.size(),
                    [&](std::size_t i) { apply_evidence(view, map.block(near_blocks[i])); });
}

void Mapper::State::apply_evidence(const ScanView& view, VoxelBlock& block) {
  const auto reach = static_cast<float>(reach_m());
  const bool block_hit = block.hit_scan == scan_count;
  const Eigen::Vector3f corner =
      view.to_sensor(voxel_key(block.key(), 0).cast<double>() * map.voxel_size_m());
  if (corner.squaredNorm() > reach * reach) return;
  const auto half_m = static_cast<float>(0.5 * map.block_size_m());
  const Eigen::Vector3f center = corner + view.R_sensor_map * Eigen::Vector3f::Constant(half_m);
  if (!block_hit && view.hides_ball(center, half_m * std::sqrt(3.0F), models)) return;
  BlockProjection seen;
  block.for_each([&](int place, Voxel& voxel) {
    if (block_hit && voxel.age == 0) return;  // new: replay judges it
    if (block_hit && voxel.idle == 0 && parameters.hit_is_support)
      support(voxel);
    else
      seen.add(place, voxel);
  });
  seen.project(corner, view, static_cast<float>(map.voxel_size_m()));
  judge(block, seen, view);
}

void Mapper::State::judge(const VoxelBlock& block, BlockProjection& seen, const ScanView& view) {
  CellMask surface = 0;
  bool surface_known = false;
  seen.for_each_told(view, models, [&](int place, Voxel& voxel, const Spherical& here) {
    const FusedEvidence evidence = view.evidence(here, models);
    if (evidence.kind() == Evidence::kUnknown) return;
    float factor = 1;
    if (evidence.kind() == Evidence::kConflict) {
      if (!surface_known) surface = near_standing_surface(block.key());
      surface_known = true;
      factor = conflict_factor(voxel, (surface & cell_bit(place)) != 0);
      voxel.see_through();
    }
    const float increment = evidence.increment(voxel.log_odds(), p_static[voxel.log_odds_fixed]);
    voxel.set_log_odds(recursion(voxel.log_odds(), factor * increment));
  });
}

void Mapper::State::support(Voxel& voxel) const {
  const float log_odds = voxel.log_odds();
  const bool full = parameters.full_support_on_return && voxel.came_back != 0;
  const float eta = full ? models.front().eta : own_hit.eta(log_odds);
  voxel.set_log_odds(recursion(log_odds, support_increment(eta, p_static[voxel.log_odds_fixed])));
}

float Mapper::State::conflict_factor(const Voxel& voxel, bool beside_surface) const {
  const double porous = voxel.came_back != 0 ? parameters.conflict_porous : 1.0;
  return static_cast<float>(beside_surface ? porous * parameters.conflict_beside_surface : porous);
}

}  // namespace stillmap
