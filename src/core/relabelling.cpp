#include <optional>

#include "for_rows.hpp"
#include "mapper_state.hpp"
#include "neighbouring_voxels.hpp"

namespace stillmap {

// Where the map stays undecided, what was said at the scan's own time stands; so does a mover that nobody has
// looked through since: its own returns, in a few scans, make no surface. A leaf that was seen through and
// hit again moved only where hardly a doubt is left.
bool Mapper::State::overrules(const Voxel& voxel, Label label_of_map, Label label_online) const {
  constexpr float kHardlyADoubt = -2.0F;  // log-odds
  if (label_of_map == Label::kUncertain || label_of_map == label_online) return false;
  const bool is_leaf = parameters.spare_porous && voxel.came_back != 0;
  if (label_of_map == Label::kDynamic && is_leaf && voxel.log_odds() > kHardlyADoubt) return false;
  return label_of_map == Label::kDynamic || label_online == Label::kUncertain ||
         voxel.hits >= parameters.hits_to_overrule;
}

ScanLabels Mapper::relabel(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                           const ScanLabels& online) const {
  State& s = up_to_date();  // the map stays what it is; the tiles around the scan are opened
  s.rolling.move_to(T_map_sensor.translation());
  s.rolling.leave(T_map_sensor.translation(), s.scan_count);
  const GateSettings gate_values = gate_settings(s.parameters);
  const auto gates =
      gate_values.any() ? std::make_optional<StructureGates>(s.map, gate_values) : std::nullopt;
  ScanLabels settled = online;
  s.arena.run([&] {
    const Eigen::Isometry3d T_aligned = s.realigned(scan, T_map_sensor);
    for_rows(scan.points.size(), [&](std::size_t first, std::size_t last) {
      NeighbouringVoxels voxels(s.map);
      for (std::size_t row = first; row < last; ++row) {
        if (online.label[row] == Label::kInvalid || online.reason[row] == Reason::kOutOfRange) continue;
        const VoxelKey key = s.map.key_of(T_aligned * scan.points[row].cast<double>());
        const Voxel* const voxel = voxels.find(key);
        if (voxel != nullptr) s.settle_by_map(settled, row, key, *voxel, gates ? &*gates : nullptr);
      }
    });
  });
  if (s.parameters.settle_objects_together) s.settle_objects(settled);
  return settled;
}

void Mapper::State::settle_by_map(ScanLabels& settled, std::size_t row, const VoxelKey& key,
                                  const Voxel& voxel, const StructureGates* gates) const {
  const float p = p_static[voxel.log_odds_fixed];
  const Label label = decision(p), online = settled.label[row];
  if (gates != nullptr && label == Label::kDynamic && !gates->dynamic_may_stand(key)) {
    settled.label[row] = Label::kUncertain;
    settled.reason[row] = Reason::kMixedEvidence;
    return;
  }
  if (!overrules(voxel, label, online)) return;
  // The map speaks of the ground, on which there was a foot.
  const bool is_foot = settled.reason[row] == Reason::kObjectMoves && settled.object[row] == kNoObject;
  if (parameters.take_feet_along && online == Label::kDynamic && is_foot) return;
  settled.label[row] = label;
  settled.reason[row] = label == Label::kStatic ? Reason::kSupported : Reason::kSeenThroughLater;
  settled.p_static[row] = parameters.calibrate_p_static ? calibration(settled.reason[row], p) : p;
}

// Feet that share their voxels with the ground, a side that slid along itself, what was never seen through.
void Mapper::State::settle_objects(ScanLabels& settled) const {
  std::vector<Votes> votes;
  for (std::size_t row = 0; row < settled.object.size(); ++row) {
    const std::int32_t object = settled.object[row];
    if (object == kNoObject) continue;
    if (votes.size() <= static_cast<std::size_t>(object)) votes.resize(object + 1);
    votes[object].add(settled.label[row], {});
  }
  for (std::size_t row = 0; row < settled.object.size(); ++row) {
    const std::int32_t object = settled.object[row];
    if (object == kNoObject || settled.label[row] == Label::kDynamic || !votes[object].moved_in_the_end())
      continue;
    settled.label[row] = Label::kDynamic;
    settled.reason[row] = Reason::kObjectMoves;
    settled.p_static[row] = parameters.calibrate_p_static
                                ? calibration(Reason::kObjectMoves, decision.p_dynamic_max)
                                : decision.p_dynamic_max;
  }
}

}  // namespace stillmap
