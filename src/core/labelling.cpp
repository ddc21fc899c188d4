#include <optional>

#include "for_rows.hpp"
#include "mapper_state.hpp"
#include "structure_gates.hpp"

namespace stillmap {

void Mapper::State::decide(const ScanView& view) {
  const std::size_t n = voxel_of_row.size();
  labels.label.resize(n);
  labels.p_static.resize(n);
  labels.reason.resize(n);
  on_old_surface.resize(n);
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
  for (std::uint32_t i = 0; i < hit.row_count; ++i) {
    const std::uint32_t row = rows_by_block[hit.first_row + i];
    const Voxel& voxel = hit.block->stored(voxel_of_row[row].rank);
    const float p = p_static[voxel.log_odds_fixed];
    const Label label = decision(p);
    on_old_surface[row] = voxel.age >= scans_of_all(kYoungScans);
    labels.p_static[row] = p;
    labels.label[row] = label;
    labels.reason[row] =
        label == Label::kStatic ? Reason::kSupported : reason_of(*hit.block, voxel_of_row[row], label, view);
  }
}

Reason Mapper::State::reason_of(const VoxelBlock& block, const VoxelRef& ref, Label label,
                                const ScanView& view) const {
  const Voxel& voxel = block.stored(ref.rank);
  if (label == Label::kUncertain)
    return voxel.age == 0 && voxel.log_odds_fixed == untold.log_odds_fixed ? Reason::kNeverJudged
                                                                           : Reason::kMixedEvidence;
  if (parameters.hit_is_support) return Reason::kSeenThrough;
  const Eigen::Vector3d in_edges =
      voxel_key(block.key(), ref.place).cast<double>() + voxel.surface_offset().cast<double>();
  const FusedEvidence now = view.evidence(view.to_sensor(in_edges * map.voxel_size_m()), models);
  return now.kind() == Evidence::kConflict ? Reason::kSeenThroughNow : Reason::kSeenThrough;
}

void Mapper::State::calibrate() {
  for_rows(labels.p_static.size(), [this](std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row)
      labels.p_static[row] = calibration(labels.reason[row], labels.p_static[row]);
  });
}

// Where the map stays undecided, what was said at the scan's own time stands; so does a mover that nobody has
// looked through since: its own returns, in a few scans, make no surface.
bool Mapper::State::overrules(const Voxel& voxel, Label label_of_map, Label label_online) const {
  if (label_of_map == Label::kUncertain || label_of_map == label_online) return false;
  return label_of_map == Label::kDynamic || label_online == Label::kUncertain ||
         voxel.hits >= parameters.hits_to_overrule;
}

ScanLabels Mapper::relabel(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                           const ScanLabels& online) const {
  constexpr double kOffSurfaceM = 0.02;
  State& s = up_to_date();  // the map stays what it is; the tiles around the scan are opened
  s.rolling.move_to(T_map_sensor.translation());
  s.rolling.leave(T_map_sensor.translation(), s.scan_count);
  const GateSettings gate_values = gate_settings(s.parameters);
  const auto gates =
      gate_values.any() ? std::make_optional<StructureGates>(s.map, gate_values) : std::nullopt;
  ScanLabels settled = online;
  for (std::size_t row = 0; row < scan.points.size(); ++row) {
    if (online.label[row] == Label::kInvalid || online.reason[row] == Reason::kOutOfRange) continue;
    const Eigen::Vector3d point_map_m = T_map_sensor * scan.points[row].cast<double>();
    const VoxelKey key = s.map.key_of(point_map_m);
    const Voxel* voxel = s.map.find(key);
    if (voxel == nullptr) continue;
    const float p_static = s.p_static[voxel->log_odds_fixed];
    const Label label = s.decision(p_static);
    if (gates && label == Label::kDynamic && !gates->dynamic_may_stand(key)) {
      settled.label[row] = Label::kUncertain;
      settled.reason[row] = Reason::kMixedEvidence;
      continue;
    }
    if (!s.overrules(*voxel, label, online.label[row])) continue;
    // The map speaks of the surface in the voxel; a foot above the ground there is not of it.
    const bool above = point_map_m.z() - s.map.surface_z_m(key, *voxel) > kOffSurfaceM;
    if (s.parameters.take_feet_along && online.label[row] == Label::kDynamic && above) continue;
    settled.label[row] = label;
    settled.reason[row] = label == Label::kStatic ? Reason::kSupported : Reason::kSeenThroughLater;
    settled.p_static[row] =
        s.parameters.calibrate_p_static ? s.calibration(settled.reason[row], p_static) : p_static;
  }
  return settled;
}

}  // namespace stillmap
