#include <tsl/robin_map.h>

#include "mapper_state.hpp"
#include "stillmap/voxel_sum.hpp"

namespace stillmap {
namespace {

/// A voxel's place after the correction. It stays one voxel; where in it the surface lies turns with it.
PlacedVoxel moved(const PlacedVoxel& placed, const Eigen::Isometry3d& T_new_old, const VoxelMap& map) {
  const Eigen::Vector3d in_edges = placed.key.cast<double>() + placed.voxel.surface_offset().cast<double>();
  const Eigen::Vector3d place = T_new_old * (in_edges * map.voxel_size_m()) * map.inverse_voxel_size();
  PlacedVoxel result{place.array().floor().cast<int>(), placed.voxel};
  result.voxel.set_surface((place - result.key.cast<double>()).cast<float>());
  return result;
}

}  // namespace

TrajectoryCorrection Mapper::correct_trajectory(const std::vector<StampedPose>& corrected) {
  State& s = up_to_date();
  s.require_submaps();
  return s.correct(s.submaps.trajectory().correction(corrected));
}

TrajectoryCorrection Mapper::correct_newest_pose(const Eigen::Isometry3d& T_new_old) {
  State& s = up_to_date();
  s.require_submaps();
  return s.correct(s.submaps.trajectory().spread(T_new_old, s.submaps.corrected_until_ns));
}

void Mapper::State::require_submaps() const {
  if (submaps.enabled()) return;
  throw std::invalid_argument(
      "submap_length_m is 0, so the map cannot follow a corrected trajectory; set it, to 10 m");
}

TrajectoryCorrection Mapper::State::correct(const PastCorrection& correction) {
  TrajectoryCorrection result;
  if (correction.empty()) return result;
  for (const Submap& submap : submaps.all()) {
    if (!submap.anchored || submap.views.empty()) continue;
    const Eigen::Vector3d place = submap.views.front().origin_map_m;
    ++result.submaps;
    result.largest_m = std::max(result.largest_m, (correction.at(submap.stamp_ns) * place - place).norm());
  }
  result.applied = result.largest_m >= map.voxel_size_m();
  if (!result.applied) return result;
  ++revision;
  arena.run([&] {
    move_submaps(correction);
    place_submaps();
  });
  for (SensorState& sensor : sensors)
    sensor.history.for_each([&](ScanView& view) { view.move(correction.at(view.stamp_ns)); });
  submaps.trajectory().apply(correction);
  submaps.corrected_until_ns = stamp_ns;
  return result;
}

void Mapper::State::move_submaps(const PastCorrection& correction) {
  VoxelReader now(rolling, scan_count);
  for (Submap& submap : submaps.all()) {
    if (!submap.closed) Submaps::refresh(submap, now);
    if (!submap.anchored) continue;
    const Eigen::Isometry3d T_new_old = correction.at(submap.stamp_ns);
    for (PlacedVoxel& placed : submap.voxels) placed = moved(placed, T_new_old, map);
    for (ScanView& view : submap.views) view.move(T_new_old);
  }
}

void Mapper::State::place_submaps() {
  map = VoxelMap(map.voxel_size_m());
  moving_blocks.clear();
  moving_around.clear();
  hit_blocks.clear();
  const std::vector<Submap>& all = submaps.all();
  for (std::size_t k = 0; k < all.size(); ++k) {
    // The submap right before has this one's evidence in its own log-odds.
    const StandingCells standing = standing_cells(all[k]);
    for (const ScanView& view : all[k].views) {
      map.find_near(view.origin_map_m, reach_m(), near_tiles);
      const CoarseView coarse(view, models);
      for_each_index(near_tiles.size(), [&](std::size_t i) {
        for (const BlockEntry& entry : *near_tiles[i])
          judge_again(view, coarse, map.block(entry.index), standing);
      });
    }
    if (k > 0) place(all[k - 1]);
  }
  if (!all.empty()) place(all.back());
  rolling.adopt_map();
}

void Mapper::State::place(const Submap& submap) {
  for (const PlacedVoxel& placed : submap.voxels) {
    VoxelBlock& block = map.block(map.find_or_create_block(block_key(placed.key)));
    block.age(scan_count);
    const int place = place_in_block(placed.key);
    Voxel moved_here = placed.voxel;
    moved_here.grow_older(scan_count - submap.scan);
    bool created = false;
    Voxel& voxel = block.find_or_create(place, created);
    map.count_created(created);
    voxel = created ? moved_here : sum(voxel, moved_here, recursion.log_odds_min, recursion.log_odds_max);
    if (voxel.came_back != 0 && voxel.log_odds() > 0) block.porous |= cell_bit(place);
  }
}

Mapper::State::StandingCells Mapper::State::standing_cells(const Submap& submap) const {
  StandingCells cells;
  const float established = log_odds_from_p(decision.p_static_min);
  for (const PlacedVoxel& placed : submap.voxels)
    if (placed.voxel.log_odds() >= established)
      cells[packed(block_key(placed.key))] |= cell_bit(place_in_block(placed.key));
  return cells;
}

void Mapper::State::judge_again(const ScanView& view, const CoarseView& coarse, VoxelBlock& block,
                                const StandingCells& standing) {
  const auto half_m = static_cast<float>(0.5 * map.block_size_m());
  const Eigen::Vector3d low = voxel_key(block.key(), 0).cast<double>() * map.voxel_size_m();
  const Eigen::Vector3f center = view.to_sensor(low + Eigen::Vector3d::Constant(half_m));
  if (center.norm() > static_cast<float>(reach_m()) || !coarse.may_tell(center, half_m * std::sqrt(3.0F)))
    return;
  std::array<CellMask, 27> around{};
  for (int i = 0; i < 27; ++i) {
    const auto found = standing.find(packed(block.key() + BlockKey(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
    if (found != standing.end()) around[i] = found->second;
  }
  const CellMask surface = grown(around);
  const CellMask porous = near_porous(block.key(), ~CellMask{0});
  const BeamShare share = beam_share(sensors[view.sensor].beams);
  block.for_each([&](int place, Voxel& voxel) {
    const Eigen::Vector3d in_edges =
        voxel_key(block.key(), place).cast<double>() + voxel.surface_offset().cast<double>();
    const Spherical here = spherical(view.to_sensor(in_edges * map.voxel_size_m()));
    const FusedEvidence evidence = view.evidence(here, models);
    if (evidence.kind() == Evidence::kUnknown) return;
    float factor = 1;
    if (evidence.kind() == Evidence::kConflict) {
      const CellMask cell = cell_bit(place);
      const bool is_porous = voxel.came_back != 0 || (porous & cell) != 0;
      factor = conflict_factor(is_porous, (surface & cell) != 0) * share.at(here.range_m);
      voxel.see_through();
    }
    voxel.set_log_odds(recursion(voxel.log_odds(), factor * evidence.increment(voxel.log_odds())));
  });
}

void Mapper::State::remember_for_corrections(const ScanView& view, const Eigen::Isometry3d& T_map_sensor) {
  std::vector<VoxelKey> born;
  born.reserve(new_voxels.size());
  for (const NewVoxel& voxel : new_voxels)
    born.push_back(voxel_key(map.block(voxel.block).key(), static_cast<int>(voxel.place)));
  submaps.add({view.stamp_ns, T_map_sensor}, view.sensor == 0, view, born, VoxelReader(rolling, scan_count));
}

}  // namespace stillmap
