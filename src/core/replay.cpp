#include <algorithm>

#include "beam_share.hpp"
#include "for_rows.hpp"
#include "mapper_state.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kAtOnce = 1024;

/// New voxels that are judged together, one coordinate after the other.
struct Batch {
  std::size_t size = 0;
  const std::uint32_t* rows;  ///< whose returns made them
  double x_map_m[kAtOnce], y_map_m[kAtOnce], z_map_m[kAtOnce];
  float log_odds[kAtOnce];
  float conflict_factor[kAtOnce];  ///< 0 until the first conflict
  // As the present one of the earlier scans sees them.
  float azimuth_rad[kAtOnce], elevation_rad[kAtOnce], range_m[kAtOnce];
  int told[kAtOnce];
};

STILLMAP_VECTOR_CLONES void see(Batch& batch, const Eigen::Vector3d& origin_map_m,
                                const Eigen::Matrix3f& R_sensor_map) {
  // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): a copy stays in registers
  const Eigen::Matrix3f R = R_sensor_map;
  const double x0 = origin_map_m.x(), y0 = origin_map_m.y(), z0 = origin_map_m.z();
  for (std::size_t i = 0; i < batch.size; ++i) {
    const auto dx = static_cast<float>(batch.x_map_m[i] - x0);
    const auto dy = static_cast<float>(batch.y_map_m[i] - y0);
    const auto dz = static_cast<float>(batch.z_map_m[i] - z0);
    const float x = R(0, 0) * dx + (R(0, 1) * dy + R(0, 2) * dz);
    const float y = R(1, 0) * dx + (R(1, 1) * dy + R(1, 2) * dz);
    const float z = R(2, 0) * dx + (R(2, 1) * dy + R(2, 2) * dz);
    const float flat = std::sqrt(x * x + y * y);
    batch.azimuth_rad[i] = fast_atan2(y, x);
    batch.elevation_rad[i] = fast_atan2(z, flat);
    batch.range_m[i] = std::sqrt(flat * flat + z * z);
  }
}

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
  batch.rows = &new_voxels[first];
  for (; batch.size < last - first; ++batch.size) {
    const std::uint32_t row = batch.rows[batch.size];
    const Eigen::Vector3d point(projected.x_m[row], projected.y_m[row], projected.z_m[row]);
    const Eigen::Vector3d point_map_m = T_map_sensor * point;
    batch.x_map_m[batch.size] = point_map_m.x();
    batch.y_map_m[batch.size] = point_map_m.y();
    batch.z_map_m[batch.size] = point_map_m.z();
    batch.log_odds[batch.size] = batch.conflict_factor[batch.size] = 0;
  }
  const auto judge = [&](const ScanView& earlier, std::uint32_t newest_scan, const BeamShare& share) {
    see(batch, earlier.origin_map_m, earlier.R_sensor_map);
    earlier.find_told(batch.size, batch.azimuth_rad, batch.elevation_rad, batch.range_m, models, batch.told);
    // What moves slowly was nearly here a moment ago: only older scans speak for the surface.
    const auto age = static_cast<int>(newest_scan - earlier.scan_index);
    const bool may_support = age >= parameters.replay_support_min_age;
    for (std::size_t i = 0; i < batch.size; ++i) {
      if (batch.told[i] == 0) continue;
      const bool support = batch.told[i] != ScanView::kConflict;
      if (support && !may_support) continue;
      const Spherical seen{batch.azimuth_rad[i], batch.elevation_rad[i], batch.range_m[i]};
      const FusedEvidence evidence =
          support ? strongest_support(batch.told[i], models) : earlier.evidence(seen, models);
      float& factor = batch.conflict_factor[i];
      if (!support && factor <= 0) factor = replay_conflict_factor(voxel_of_row[batch.rows[i]]);
      const float weight = support ? 1.0F : factor * share.at(batch.range_m[i]);
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
  for (std::size_t i = 0; i < batch.size; ++i) {
    float log_odds = batch.log_odds[i];
    Voxel& voxel = voxel_of(voxel_of_row[batch.rows[i]]);
    voxel.moved_in = log_odds < moved_in_below;
    if (parameters.hit_is_support) log_odds = recursion(log_odds, own_hit.increment(log_odds));
    voxel.set_log_odds(log_odds);
  }
}

float Mapper::State::replay_conflict_factor(const VoxelRef& voxel) const {
  const CellMask here = cell_bit(voxel.place);
  const bool beside = (near_porous(map.block(voxel.block).key(), here) & here) != 0;
  return beside ? static_cast<float>(parameters.conflict_porous) : 1.0F;
}

}  // namespace stillmap
