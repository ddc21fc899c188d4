#include <algorithm>

#include "beam_share.hpp"
#include "for_rows.hpp"
#include "mapper_state.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kAtOnce = 1024;

/// New voxels that are judged together, one coordinate after the other.
struct Batch {
  const NewVoxel* made;
  MapPoints points;
  float log_odds[kAtOnce];
  float conflict_factor[kAtOnce];  ///< 0 until the first conflict
  int told[kAtOnce];               ///< by the present one of the earlier scans
};

/// What evidence() says where the strongest support is of this rank.
FusedEvidence strongest_support(int rank, const std::vector<LevelModel>& models) {
  FusedEvidence evidence;
  for (const LevelModel& model : models)
    if (model.support_rank == rank) evidence.support(model);
  return evidence;
}

}  // namespace

void Mapper::State::replay_history(const Eigen::Isometry3d& T_map_sensor) {
  for_pieces(new_voxels.size(), kAtOnce / 2, [&](std::size_t first, std::size_t last) {
    for (; first < last; first += kAtOnce)
      replay_history(T_map_sensor, first, std::min(last, first + kAtOnce));
  });
}

void Mapper::State::replay_history(const Eigen::Isometry3d& T_map_sensor, std::size_t first,
                                   std::size_t last) {
  Batch batch;
  batch.made = &new_voxels[first];
  const std::size_t size = last - first;
  MapPoints& points = batch.points;
  points.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t row = batch.made[i].row;
    const Eigen::Vector3d point(projected.x_m[row], projected.y_m[row], projected.z_m[row]);
    points.add(T_map_sensor * point);
    batch.log_odds[i] = batch.conflict_factor[i] = 0;
  }
  const auto judge = [&](const ScanView& earlier, std::uint32_t newest_scan, const BeamShare& share) {
    points.see_from(earlier);
    earlier.find_told(size, points.azimuth_rad.data(), points.elevation_rad.data(), points.range_m.data(),
                      models, batch.told);
    // What moves slowly was nearly here a moment ago: only older scans speak for the surface.
    const auto age = static_cast<int>(newest_scan - earlier.scan_index);
    const bool may_support = age >= parameters.replay_support_min_age;
    for (std::size_t i = 0; i < size; ++i) {
      if (batch.told[i] == 0) continue;
      const bool support = batch.told[i] != ScanView::kConflict;
      if (support && !may_support) continue;
      const Spherical seen{points.azimuth_rad[i], points.elevation_rad[i], points.range_m[i]};
      const FusedEvidence evidence =
          support ? strongest_support(batch.told[i], models) : earlier.evidence(seen, models);
      float& factor = batch.conflict_factor[i];
      if (!support && factor <= 0) factor = replay_conflict_factor(batch.made[i]);
      const float weight = support ? 1.0F : factor * share.at(points.range_m[i]);
      const float log_odds = batch.log_odds[i];
      batch.log_odds[i] = recursion(log_odds, weight * evidence.increment(log_odds));
    }
  };
  for (const SensorState& sensor : sensors) {
    const BeamShare share = beam_share(sensor.beams);
    sensor.history.for_each([&](const ScanView& earlier) { judge(earlier, sensor.scans, share); });
  }
  constexpr float kClearly = 0.75F;  // of log_odds_min: several scans, each beyond doubt
  const float moved_in_below = kClearly * recursion.log_odds_min;
  for (std::size_t i = 0; i < size; ++i) {
    float log_odds = batch.log_odds[i];
    Voxel& voxel = map.block(batch.made[i].block).stored(batch.made[i].rank);
    voxel.moved_in = log_odds < moved_in_below;
    if (parameters.hit_is_support) log_odds = recursion(log_odds, own_hit.increment(log_odds));
    voxel.set_log_odds(log_odds);
  }
}

float Mapper::State::replay_conflict_factor(const NewVoxel& voxel) const {
  const CellMask here = cell_bit(voxel.place);
  const bool beside = (near_porous(map.block(voxel.block).key(), here) & here) != 0;
  return beside ? static_cast<float>(parameters.conflict_porous) : 1.0F;
}

}  // namespace stillmap
