#include "for_rows.hpp"
#include "mapper_state.hpp"

namespace stillmap {

void Mapper::State::decide(const ScanView& view) {
  const std::size_t n = projected.size();
  labels.label.resize(n);
  labels.p_static.resize(n);
  labels.reason.resize(n);
  if (!parameters.resolve_objects) labels.object.assign(n, kNoObject);
  on_old_surface.resize(n);
  on_porous.resize(n);
  for_rows(n, [this](std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row) {
      const bool too_far = projected.range_m[row] < 0;
      labels.label[row] = too_far ? Label::kUncertain : Label::kInvalid;
      labels.p_static[row] = 0.5F;
      labels.reason[row] = too_far ? Reason::kOutOfRange : Reason::kNoReturn;
    }
  });
  for_each_hit_block([&](const HitBlock& hit) { decide_rows(hit, view); });
}

void Mapper::State::decide_rows(const HitBlock& hit, const ScanView& view) {
  constexpr int kYoungScans = 10;
  const int old = static_cast<int>(scans_of_all(kYoungScans));
  int rank = -1;  // rows that follow each other mostly lie in one voxel
  float p = 0;
  auto label = Label::kUncertain;
  auto reason = Reason::kNeverJudged;
  bool is_old = false, is_porous = false;
  for (std::uint32_t i = hit.first_row; i < hit.first_row + hit.row_count; ++i) {
    const std::uint32_t row = rows_by_block[i];
    if (ranks_by_block[i] != rank) {
      rank = ranks_by_block[i];
      const Voxel& voxel = hit.block->stored(rank);
      p = p_static[voxel.log_odds_fixed];
      label = decision(p);
      is_old = voxel.age >= old;
      is_porous = voxel.came_back != 0;
      reason = label == Label::kStatic ? Reason::kSupported
                                       : reason_of(*hit.block, voxel, located.place[row], label, view);
    }
    on_old_surface[row] = is_old;
    on_porous[row] = is_porous;
    labels.p_static[row] = p;
    labels.label[row] = label;
    labels.reason[row] = reason;
  }
}

Reason Mapper::State::reason_of(const VoxelBlock& block, const Voxel& voxel, int place, Label label,
                                const ScanView& view) const {
  if (label == Label::kUncertain)
    return voxel.age == 0 && voxel.log_odds_fixed == untold.log_odds_fixed ? Reason::kNeverJudged
                                                                           : Reason::kMixedEvidence;
  if (parameters.hit_is_support) return Reason::kSeenThrough;
  const Eigen::Vector3d in_edges =
      voxel_key(block.key(), place).cast<double>() + voxel.surface_offset().cast<double>();
  const FusedEvidence now = view.evidence(view.to_sensor(in_edges * map.voxel_size_m()), models);
  return now.kind() == Evidence::kConflict ? Reason::kSeenThroughNow : Reason::kSeenThrough;
}

void Mapper::State::calibrate() {
  for_rows(labels.p_static.size(), [this](std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row)
      labels.p_static[row] = calibration(labels.reason[row], labels.p_static[row]);
  });
}

}  // namespace stillmap
