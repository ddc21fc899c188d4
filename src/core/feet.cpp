#include "for_rows.hpp"
#include "mapper_state.hpp"

namespace stillmap {

// Feet and tyres share their voxels with the ground, which stands. What rises a little above it right below a
// moving thing is not the ground.
void Mapper::State::take_feet_along() {
  constexpr float kSureM = 0.02F, kHighestM = 0.3F;  // above the ground
  constexpr float kLowestM = -0.05F;                 // above what may be feet itself
  constexpr float kBesideM = 0.25F, kRightBelowM = 0.05F;
  if (moving_rows.empty()) return;
  // Above most of the ground nothing moves. What is settled here may lie above another foot.
  moves_above_pixel.assign(clusters.pixels(), 0);
  for (const std::uint32_t row : moving_rows)
    if (labels.label[row] == Label::kDynamic) note_mover(row);
  find_rows(projected.size(), low_rows, [this](std::size_t row) {
    const float height_m = height_above_ground_m[row];
    return (height_m > kLowestM) & (height_m < kHighestM);
  });
  low_pixels.resize(low_rows.size());
  for_rows(low_rows.size(), [this](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) low_pixels[i] = pixel_of(low_rows[i]);
  });
  for (std::size_t i = 0; i < low_rows.size(); ++i) {
    const std::uint32_t row = low_rows[i];
    if (moves_above_pixel[low_pixels[i]] == 0) continue;
    if (!is_judged(row) || labels.label[row] == Label::kDynamic) continue;
    const float height_m = upright.z_m[row] - ground.height_beside_m(upright.ground_cell[row]);
    if (height_m <= 0) continue;
    const float beside_m = height_m > kSureM ? kBesideM : kRightBelowM;  // a sole, or the ground beside it
    const auto moves_right_above = [&](std::int32_t above) {
      const float dx_m = upright.x_m[above] - upright.x_m[row], dy_m = upright.y_m[above] - upright.y_m[row];
      return labels.label[above] == Label::kDynamic && dx_m * dx_m + dy_m * dy_m < beside_m * beside_m &&
             belongs_to_mover(above);
    };
    if (!clusters.any_above(low_pixels[i], moves_right_above)) continue;
    settle(row, Reason::kObjectMoves);
    note_mover(row);
  }
}

int Mapper::State::pixel_of(std::uint32_t row) const {
  return clusters.pixel(projected.azimuth_rad[row], projected.elevation_rad[row]);
}

void Mapper::State::note_mover(std::uint32_t row) {
  const int pixel = pixel_of(row);
  if (clusters.is_in_front(row, pixel) && belongs_to_mover(static_cast<std::int32_t>(row)))
    clusters.for_each_below(pixel, [this](int below) { moves_above_pixel[below] = 1; });
}

// A few dynamic returns of a tuft of grass have no feet.
bool Mapper::State::belongs_to_mover(std::int32_t row) const {
  const std::int32_t object = clusters.of_row()[row];
  if (object == Clusters::kNone) return false;
  return moves(object_votes[object].verdict(kObjectStatic)) ||
         moves(patch_votes[patch_of_row[row]].verdict(kPatchStatic));
}

}  // namespace stillmap
