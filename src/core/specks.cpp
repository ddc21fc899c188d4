#include "mapper_state.hpp"

namespace stillmap {
namespace {

/// Returns that a patch of `edge_m` gets at this range; what is smaller is a speck.
float speck_rows(float edge_m, float range_m, SensorGeometry beams) {
  constexpr float kLeast = 5.0F, kMost = 200.0F;
  const float angle_rad = edge_m / range_m;
  return std::clamp(angle_rad * angle_rad / (beams.ring_spacing_rad * beams.azimuth_step_rad), kLeast, kMost);
}

bool mostly_static(const Votes& votes) {
  constexpr float kMajority = 0.65F;
  return static_cast<float>(votes.is_static) >
         kMajority * static_cast<float>(votes.is_static + votes.dynamic);
}

}  // namespace

void Mapper::State::defer_specks() {
  constexpr int kLoneRows = 3;  // on the ground
  if (parameters.speck_size_m <= 0) return;
  moving_pieces.find(projected, beams, moving_rows);
  std::vector<int> size(moving_pieces.count(), 0);
  for (const std::uint32_t row : moving_rows)
    if (moving_pieces.of_row()[row] != Clusters::kNone) ++size[moving_pieces.of_row()[row]];
  for (const std::uint32_t row : moving_rows) {
    const std::int32_t piece = moving_pieces.of_row()[row], object = clusters.of_row()[row];
    const int rows = piece == Clusters::kNone ? 1 : size[piece];
    const bool stands = object == Clusters::kNone ? rows < kLoneRows : mostly_static(object_votes[object]);
    if (!stands ||
        rows >= speck_rows(static_cast<float>(parameters.speck_size_m), projected.range_m[row], beams))
      continue;
    labels.label[row] = Label::kUncertain;
    labels.reason[row] = Reason::kMixedEvidence;
  }
}

}  // namespace stillmap
