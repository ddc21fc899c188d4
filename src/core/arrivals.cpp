#include "mapper_state.hpp"

namespace stillmap {
namespace {

/// Rows of an object of which the map itself says that they move.
struct SureRows {
  float log_odds_sum = 0;
  int rows = 0;
  int arriving = 0, porous = 0;  ///< of all its rows that move

  float mean() const { return log_odds_sum / static_cast<float>(rows); }
  bool speak_for(const Votes& object) const {
    constexpr int kSeveral = 5;
    constexpr float kEnough = 0.15F, kHardlyAny = 0.02F;  // leaves move as a whole, too, now and then
    return static_cast<float>(porous) <= kHardlyAny * static_cast<float>(arriving) && rows >= kSeveral &&
           static_cast<float>(rows) >= kEnough * static_cast<float>(object.rows);
  }
};

}  // namespace

// Who comes towards the sensor, or goes away from it, hides the place that he moves into: most of his voxels
// were never seen through, and once he stops they would stand within a second. What the sure rows of a thing
// that moves as a whole say holds for all its new voxels.
void Mapper::State::remember_arrivals() {
  const auto arrives = [this](std::uint32_t row) {
    const std::int32_t object = clusters.of_row()[row];
    return object != Clusters::kNone && labels.label[row] == Label::kDynamic &&
           object_votes[object].moves_as_a_whole() && moves(object_votes[object].verdict(kObjectStatic));
  };
  std::vector<SureRows> sure_rows(clusters.count());
  for (const std::uint32_t row : moving_rows) {
    if (!arrives(row)) continue;
    SureRows& sure = sure_rows[clusters.of_row()[row]];
    ++sure.arriving;
    sure.porous += on_porous[row];
    if (labels.reason[row] != Reason::kSeenThrough) continue;
    sure.log_odds_sum += map.block(block_of(row)).at(located.place[row]).log_odds();
    ++sure.rows;
  }
  for (const std::uint32_t row : moving_rows) {
    // Only beside what moved in the last scans: what is swept up by a vote must not stay.
    if (followed[row] == 0 || on_old_surface[row] != 0 || !arrives(row)) continue;
    const SureRows& sure = sure_rows[clusters.of_row()[row]];
    if (!sure.speak_for(object_votes[clusters.of_row()[row]])) continue;
    Voxel& voxel = map.block(block_of(row)).at(located.place[row]);
    if (voxel.came_back != 0 || voxel.log_odds() <= sure.mean()) continue;
    voxel.set_log_odds(sure.mean());
    voxel.moved_in = 1;
  }
}

}  // namespace stillmap
