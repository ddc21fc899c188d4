#include "beam_share.hpp"
#include "block_projection.hpp"
#include "coarse_image.hpp"
#include "mapper_state.hpp"
#include "vector_clones.hpp"

namespace stillmap {

// Blocks own their voxels and read only what no other block writes: any order gives the same map.
//
// Where a return is support by itself, labels need nothing else of the present scan; where it is not, they
// need what its image says of the blocks that it hit.
void Mapper::State::apply_evidence_to_hits(const ScanView& view) {
  if (!every_voxel_is_judged)
    apply_evidence_to_nearest(view);
  else if (!parameters.hit_is_support)
    for_each_hit_block([&](const HitBlock& hit) { judge_hit_block(view, *hit.block); });
}

void Mapper::State::apply_evidence_to_others(const ScanView& view) {
  if (!every_voxel_is_judged) return;
  if (parameters.hit_is_support)
    for_each_hit_block([&](const HitBlock& hit) { judge_hit_block(view, *hit.block); });
  map.find_near(view.origin_map_m, reach_m(), near_tiles);
  const CoarseView coarse(view, models);
  for_each_index(near_tiles.size(), [&](std::size_t i) { judge_tile(view, coarse, *near_tiles[i]); });
}

STILLMAP_VECTOR_CLONES void Mapper::State::support_returned(VoxelBlock& block,
                                                            const PlaceMask& places) const {
  for (int word = 0; word < static_cast<int>(places.size()); ++word)
    for (std::uint64_t bits = places[word]; bits != 0; bits &= bits - 1) {
      Voxel& voxel = block.at(word * 64 + __builtin_ctzll(bits));
      if (voxel.age > 0) support(voxel, support_tables.of_hit(voxel));  // replay judges new ones
    }
}

void Mapper::State::judge_hit_block(const ScanView& view, VoxelBlock& block) {
  judge_block(view, block,
              parameters.hit_is_support ? BlockProjection::Asked::kNotHit : BlockProjection::Asked::kKnown);
}

void Mapper::State::judge_block(const ScanView& view, VoxelBlock& block, BlockProjection::Asked asked) {
  BlockProjection seen;
  seen.project(block, asked, corner_of(block.key(), view), view, static_cast<float>(map.voxel_size_m()));
  seen.find_told(view, models);
  judge(view, block, seen);
}

void Mapper::State::judge_tile(const ScanView& view, const CoarseView& coarse, const BlockTile& tile) {
  constexpr std::size_t kFarAhead = 8, kAhead = 3;
  const auto half_m = static_cast<float>(0.5 * map.block_size_m());
  const Eigen::Vector3f to_center = view.R_sensor_map * Eigen::Vector3f::Constant(half_m);
  const auto reach = static_cast<float>(reach_m());
  std::vector<std::uint32_t> in_view;
  for (const BlockEntry& entry : tile) {
    if (is_hit(entry.index)) continue;
    const Eigen::Vector3f corner = corner_of(entry.key, view);
    if (corner.squaredNorm() > reach * reach) continue;
    if (coarse.may_tell(corner + to_center, half_m * std::sqrt(3.0F))) in_view.push_back(entry.index);
  }
  for (std::size_t i = 0; i < in_view.size(); ++i) {
    if (i + kFarAhead < in_view.size()) map.block(in_view[i + kFarAhead]).prefetch();
    if (i + kAhead < in_view.size()) map.block(in_view[i + kAhead]).prefetch_voxels();
    judge_block(view, map.block(in_view[i]), BlockProjection::Asked::kAll);
  }
}

Eigen::Vector3f Mapper::State::corner_of(const BlockKey& key, const ScanView& view) const {
  return view.to_sensor(voxel_key(key, 0).cast<double>() * map.voxel_size_m());
}

void Mapper::State::judge(const ScanView& view, VoxelBlock& block, const BlockProjection& seen) {
  seen.for_each_supported(
      [&](int rank, int says) { support(block.stored(rank), support_tables.of_rank(says)); });
  const CellMask seen_through = seen.seen_through();
  if (seen_through == 0) return;
  constexpr int kEmpty = 8;  // scans that saw through it: no leaf hides for so long
  const KnownSurface known = near_known_surface(block.key(), seen_through);
  const BeamShare share = beam_share(beams);
  seen.for_each_contradicted([&](int place, int rank, const Spherical& here) {
    Voxel& voxel = block.stored(rank);
    voxel.see_through();
    const CellMask cell = cell_bit(place);
    const bool is_porous =
        voxel.came_back != 0 || (voxel.seen_through < kEmpty && (known.porous & cell) != 0);
    const float factor = conflict_factor(is_porous, (known.standing & cell) != 0);
    const float increment = view.evidence(here, models).increment(voxel.log_odds());
    voxel.set_log_odds(recursion(voxel.log_odds(), factor * std::sqrt(share.at(here.range_m)) * increment));
  });
}

void Mapper::State::support(Voxel& voxel, const SupportTable& table) const {
  if (is_settling(voxel)) return let_settle(voxel);
  table.support(voxel);
}

bool Mapper::State::is_settling(const Voxel& voxel) const {
  return voxel.log_odds_fixed < 0 && voxel.moved_in != 0 && voxel.came_back == 0 &&
         parameters.settle_time_s > 0;
}

void Mapper::State::let_settle(Voxel& voxel) const {
  voxel.set_log_odds(std::min(voxel.log_odds() + settling_step, 0.0F));
}

float Mapper::State::conflict_factor(bool is_porous, bool beside_surface) const {
  const double porous = is_porous ? parameters.conflict_porous : 1.0;
  return static_cast<float>(beside_surface ? porous * parameters.conflict_beside_surface : porous);
}

BeamShare Mapper::State::beam_share(const SensorGeometry& of_beams) const {
  return {static_cast<float>(parameters.conflict_reach_voxels * map.voxel_size_m()), of_beams};
}

}  // namespace stillmap
