#include <tbb/parallel_for.h>
#include <tsl/robin_map.h>

#include "for_rows.hpp"
#include "joint_verdict.hpp"
#include "mapper_state.hpp"

namespace stillmap {
namespace {

/// The cube of 1 m that a row lies in.
BlockKey patch_cell(float x_m, float y_m, float z_m) {
  const auto floor = [](float value) {  // std::floor is a call
    const int whole = static_cast<int>(value);
    return whole - (value < static_cast<float>(whole));
  };
  return {floor(x_m), floor(y_m), floor(z_m)};
}

}  // namespace

void Mapper::State::resolve_objects(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                                    const ScanView& view) {
  upright.turn(projected, T_map_sensor.linear().cast<float>());
  separate_ground();
  clusters.find(projected, beams, takes_part);
  find_clues();
  count_votes();
  test_vanished(scan, T_map_sensor, view);
  decide_by_vote();
  defer_specks();
  if (parameters.take_insides_along) take_insides_along();
  remember_moving();
  if (parameters.take_feet_along) take_feet_along();
}

void Mapper::State::separate_ground() {
  constexpr float kGroundM = 0.1F;
  ground.fit(upright, projected);
  ground.heights_above(upright, height_above_ground_m);
  clues.resize(projected.size());
  takes_part.resize(projected.size());
  for_rows(projected.size(), [this](std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row) {
      const bool judged = voxel_of_row[row].exists();
      clues[row] = RowClues{};
      clues[row].ground = judged && height_above_ground_m[row] < kGroundM;
      takes_part[row] = judged && !clues[row].ground;
      // Newly seen ground continues known ground.
      if (clues[row].ground && labels.label[row] == Label::kUncertain) settle(row, Reason::kObjectStands);
    }
  });
}

void Mapper::State::find_clues() {
  constexpr float kLeaning = 0.45F;  // p_static
  tbb::parallel_for(std::size_t{0}, hit_blocks.size(), [this](std::size_t i) {
    const std::uint32_t* rows = &rows_by_block[hit_blocks[i].first_row];
    const std::uint32_t* const end = rows + hit_blocks[i].row_count;
    CellMask occupied = 0;
    for (const std::uint32_t* row = rows; row < end; ++row)
      if (clusters.of_row()[*row] != Clusters::kNone) occupied |= cell_bit(voxel_of_row[*row].place);
    if (occupied == 0) return;
    const CellMask moving =
        parameters.follow_objects ? near_moving(unpacked(located.block[*rows]), occupied) : CellMask{0};
    for (const std::uint32_t* row = rows; row < end; ++row) {
      if (clusters.of_row()[*row] == Clusters::kNone) continue;
      clues[*row].followed = (moving & cell_bit(voxel_of_row[*row].place)) != 0;
      clues[*row].leaning = parameters.lean_together && labels.p_static[*row] < kLeaning;
      clues[*row].established = labels.label[*row] == Label::kStatic && on_old_surface[*row] != 0;
    }
  });
}

void Mapper::State::count_votes() {
  object_votes.assign(clusters.count(), Votes{});
  patch_votes.clear();
  patch_of_row.resize(projected.size());
  tsl::robin_map<std::uint64_t, std::uint32_t, BlockKeyHash> patches;
  // Neighbouring rows mostly share a patch: they are counted together.
  struct Run {
    std::int32_t object = Clusters::kNone;
    std::uint64_t object_hash = 0, key = 0;
    std::uint32_t patch = 0;
    Votes votes;
  } run;
  const auto end_run = [&] {
    if (run.votes.rows == 0) return;
    object_votes[run.object] += run.votes;
    patch_votes[run.patch] += run.votes;
    run.votes = Votes{};
  };
  for (std::size_t row = 0; row < projected.size(); ++row) {
    const std::int32_t object = clusters.of_row()[row];
    if (object == Clusters::kNone) continue;
    const bool same_object = object == run.object;
    if (!same_object) run.object_hash = BlockKeyHash{}(static_cast<std::uint64_t>(object) + 1);
    const std::uint64_t key =
        packed(patch_cell(upright.x_m[row], upright.y_m[row], upright.z_m[row])) ^ run.object_hash;
    if (!same_object || key != run.key) {
      end_run();
      const auto [patch, created] = patches.try_emplace(key, static_cast<std::uint32_t>(patch_votes.size()));
      if (created) patch_votes.emplace_back();
      run.object = object;
      run.key = key;
      run.patch = patch->second;
    }
    patch_of_row[row] = run.patch;
    run.votes.add(labels.label[row], clues[row]);
  }
  end_run();
}

void Mapper::State::test_vanished(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                                  const ScanView& view) {
  if (!parameters.vanish_test) return;
  const ScanHistory& history = sensors[static_cast<std::size_t>(scan.sensor)].history;
  const std::array<const ScanView*, 4> before = {history.recent(1), history.recent(2), history.recent(4),
                                                 history.recent(8)};
  tbb::parallel_for(std::size_t{0}, scan.points.size(), [&](std::size_t row) {
    const bool open = clusters.of_row()[row] != Clusters::kNone && labels.label[row] != Label::kDynamic &&
                      !clues[row].established && !patch_votes[patch_of_row[row]].known_before();
    if (!open) return;
    clues[row].tested = true;
    const Eigen::Vector3d point_map_m = T_map_sensor * scan.points[row].cast<double>();
    for (const ScanView* earlier : before)
      if (!clues[row].vanished && earlier != nullptr)
        clues[row].vanished = replaced_vanished(point_map_m, *earlier, view);
  });
  for (std::size_t row = 0; row < scan.points.size(); ++row) {
    if (!clues[row].tested) continue;
    object_votes[clusters.of_row()[row]].add_vanish_test(clues[row].vanished);
    patch_votes[patch_of_row[row]].add_vanish_test(clues[row].vanished);
  }
}

bool Mapper::State::replaced_vanished(const Eigen::Vector3d& point_map_m, const ScanView& earlier,
                                      const ScanView& view) const {
  constexpr float kNearestM = 0.1F, kFarthestM = 3.0F;  // how far a thing moves away in a few scans
  const Spherical s = spherical(earlier.to_sensor(point_map_m));
  const MeasuredRange measured = earlier.levels().front().at(s.azimuth_rad, s.elevation_rad);
  const float hidden_by_m = s.range_m - measured.farthest_m;
  if (!measured.valid() || hidden_by_m < kNearestM || hidden_by_m > kFarthestM) return false;
  const Eigen::Vector3d hider_map_m =
      earlier.origin_map_m + (point_map_m - earlier.origin_map_m) * (measured.farthest_m / s.range_m);
  return view.evidence(view.to_sensor(hider_map_m), models).kind() == Evidence::kConflict;
}

void Mapper::State::decide_by_vote() {
  for (std::size_t row = 0; row < clues.size(); ++row) {
    const std::int32_t object = clusters.of_row()[row];
    const bool just_static = labels.label[row] == Label::kStatic && !clues[row].established;
    if (object == Clusters::kNone || !(labels.label[row] == Label::kUncertain || just_static)) continue;
    const Reason reason = joint_verdict(patch_votes[patch_of_row[row]], object_votes[object]);
    if (reason == Reason::kMixedEvidence) continue;
    const bool follows = parameters.follow_objects && object_votes[object].moves_as_a_whole();
    if (just_static && reason != Reason::kReplacedVanished && !follows) continue;
    settle(row, reason);
  }
}

void Mapper::State::settle(std::size_t row, Reason reason) {
  const bool stands = reason == Reason::kObjectStands;
  labels.label[row] = stands ? Label::kStatic : Label::kDynamic;
  labels.reason[row] = reason;
  labels.p_static[row] = stands ? std::max(labels.p_static[row], decision.p_static_min)
                                : std::min(labels.p_static[row], decision.p_dynamic_max);
}

}  // namespace stillmap
