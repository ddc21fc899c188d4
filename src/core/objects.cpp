#include "for_rows.hpp"
#include "joint_verdict.hpp"
#include "mapper_state.hpp"

namespace stillmap {
namespace {

constexpr float kGroundM = 0.1F;  // what rises less above it is ground

}  // namespace

void Mapper::State::find_objects(const Eigen::Isometry3d& T_map_sensor) {
  upright.turn(projected, T_map_sensor.linear().cast<float>());
  ground.fit(upright);
  ground.heights_above(upright, height_above_ground_m);
  find_rows(projected.size(), standing_rows,
            [this](std::size_t row) { return is_judged(row) & !(height_above_ground_m[row] < kGroundM); });
  clusters.find(projected, beams, standing_rows);
  labels.object = clusters.of_row();
}

void Mapper::State::resolve_objects(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                                    const ScanView& view) {
  settle_ground();
  find_followed();
  count_votes();
  if (parameters.vanish_test) test_vanished(scan, T_map_sensor, view);
  decide_by_vote();
  find_rows(projected.size(), moving_rows,
            [this](std::size_t row) { return labels.label[row] == Label::kDynamic; });
  defer_specks();
  if (parameters.remember_arrivals) remember_arrivals();
  if (parameters.take_insides_along) take_insides_along();
  if (parameters.take_feet_along) take_feet_along();
}

// Newly seen ground continues known ground.
void Mapper::State::settle_ground() {
  for_rows(projected.size(), [this](std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row)
      if (labels.label[row] == Label::kUncertain && height_above_ground_m[row] < kGroundM)
        settle(row, Reason::kObjectStands);
  });
}

void Mapper::State::find_followed() {
  followed.assign(projected.size(), 0);
  if (!parameters.follow_objects || moving_around.empty()) return;
  for_pieces(hit_blocks.size(), 64, [this](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t* const rows = &rows_by_block[hit_blocks[i].first_row];
      const auto moving = moving_around.find(located.block[*rows]);
      if (moving == moving_around.end()) continue;
      for (const std::uint32_t* row = rows; row < rows + hit_blocks[i].row_count; ++row)
        followed[*row] = (moving->second & cell_bit(located.place[*row])) != 0;
    }
  });
}

void Mapper::State::decide_by_vote() {
  patch_of_row.resize(projected.size());
  for_each_run([this](const PatchRun& run) {
    for (std::uint32_t i = run.first; i < run.last; ++i) patch_of_row[standing_rows[i]] = run.patch;
    if (run.votes.open() == 0) return;
    const Votes& object = object_votes[run.object];
    const Reason reason = joint_verdict(patch_votes[run.patch], object);
    if (reason == Reason::kMixedEvidence) return;
    // What only just turned static is taken along only by what is sure to move.
    const bool all =
        reason == Reason::kReplacedVanished || (parameters.follow_objects && object.moves_as_a_whole());
    for (std::uint32_t i = run.first; i < run.last; ++i) {
      const std::uint32_t row = standing_rows[i];
      if (labels.label[row] == Label::kUncertain || (all && is_just_static(row))) settle(row, reason);
    }
  });
}

void Mapper::State::settle(std::size_t row, Reason reason) {
  const bool stands = reason == Reason::kObjectStands;
  labels.label[row] = stands ? Label::kStatic : Label::kDynamic;
  labels.reason[row] = reason;
  labels.p_static[row] = stands ? std::max(labels.p_static[row], decision.p_static_min)
                                : std::min(labels.p_static[row], decision.p_dynamic_max);
}

}  // namespace stillmap
