#include "for_rows.hpp"
#include "mapper_state.hpp"

namespace stillmap {

// Feet and tyres share their voxels with the ground, which stands. What rises a little above it right below a
// moving thing is not the ground.
void Mapper::State::take_feet_along() {
  constexpr float kSureM = 0.02F, kHighestM = 0.3F;  // above the ground
  constexpr float kBesideM = 0.25F, kRightBelowM = 0.05F;
  if (moving_rows.empty()) return;
  // Most columns have nothing that moves. What is settled here may lie above another foot.
  moves_near_column.assign(static_cast<std::size_t>(clusters.columns()), 0);
  for (const std::uint32_t row : moving_rows)
    if (labels.label[row] == Label::kDynamic) note_mover(row);
  find_rows(projected.size(), low_rows, [this](std::size_t row) {
    const float height_m = height_above_ground_m[row];
    return (height_m > 0) & (height_m < kHighestM);
  });
  for (const std::uint32_t row : low_rows) {
    if (moves_near_column[clusters.column(projected.azimuth_rad[row])] == 0) continue;
    if (!is_judged(row) || labels.label[row] == Label::kDynamic) continue;
    const float height_m = height_above_ground_m[row];
    const float beside_m = height_m > kSureM ? kBesideM : kRightBelowM;  // a sole, or the ground beside it
    const auto moves_right_above = [&](std::int32_t above) {
      const float dx_m = upright.x_m[above] - upright.x_m[row], dy_m = upright.y_m[above] - upright.y_m[row];
      return labels.label[above] == Label::kDynamic && dx_m * dx_m + dy_m * dy_m < beside_m * beside_m &&
             belongs_to_mover(above);
    };
    if (!clusters.any_above(projected.azimuth_rad[row], projected.elevation_rad[row], moves_right_above))
      continue;
    settle(row, Reason::kObjectMoves);
    note_mover(row);
  }
}

void Mapper::State::note_mover(std::size_t row) {
  const int column = clusters.column(projected.azimuth_rad[row]), columns = clusters.columns();
  for (const int near : {column + columns - 1, column, column + 1}) moves_near_column[near % columns] = 1;
}

// A few dynamic returns of a tuft of grass have no feet.
bool Mapper::State::belongs_to_mover(std::int32_t row) const {
  const std::int32_t object = clusters.of_row()[row];
  if (object == Clusters::kNone) return false;
  return moves(object_votes[object].verdict(kObjectStatic)) ||
         moves(patch_votes[patch_of_row[row]].verdict(kPatchStatic));
}

}  // namespace stillmap
