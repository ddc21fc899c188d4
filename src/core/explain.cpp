#include <algorithm>
#include <limits>

#include "mapper_state.hpp"
#include "voxel_reader.hpp"

namespace stillmap {
namespace {

struct FoundVoxel {
  std::optional<Voxel> voxel;
  Eigen::Vector3d place_map_m;  ///< of its surface
};

/// The voxel at the place, or the nearest of those right beside: a click does not hit a voxel's inside.
FoundVoxel voxel_near(const RollingMap& rolling, std::uint32_t scan, const Eigen::Vector3d& point_map_m) {
  const VoxelMap& map = rolling.open_map();
  VoxelReader reader(rolling, scan);
  FoundVoxel nearest;
  double least_m = std::numeric_limits<double>::max();
  const VoxelKey middle = map.key_of(point_map_m);
  for (int i = 0; i < 27; ++i) {
    const VoxelKey key = middle + VoxelKey(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const std::optional<Voxel> voxel = reader.find(key);
    if (!voxel) continue;
    const Eigen::Vector3d in_edges = key.cast<double>() + voxel->surface_offset().cast<double>();
    const Eigen::Vector3d place_map_m = in_edges * map.voxel_size_m();
    const double distance_m = key == middle ? -1.0 : (place_map_m - point_map_m).norm();
    if (distance_m >= least_m) continue;
    least_m = distance_m;
    nearest = {voxel, place_map_m};
  }
  return nearest;
}

}  // namespace

Explanation Mapper::explain(const Eigen::Vector3d& point_map_m) const {
  const State& s = up_to_date();
  Explanation explanation;
  explanation.asked_map_m = explanation.place_map_m = point_map_m;
  explanation.newest_stamp_ns = s.stamp_ns;
  const FoundVoxel found = voxel_near(s.rolling, s.scan_count, point_map_m);
  if (found.voxel) {
    explanation.in_map = true;
    explanation.place_map_m = found.place_map_m;
    explanation.log_odds = found.voxel->log_odds();
    explanation.p_static = p_from_log_odds(explanation.log_odds);
    explanation.label = s.decision(explanation.p_static);
    explanation.hits = found.voxel->hits;
    explanation.seen_through = found.voxel->seen_through;
    explanation.came_back = found.voxel->came_back != 0;
  }
  for (const SensorState& sensor : s.sensors)
    sensor.history.for_each([&](const ScanView& view) {
      const auto of_scan = s.evidence_about(explanation.place_map_m, view);
      explanation.evidence.insert(explanation.evidence.end(), of_scan.begin(), of_scan.end());
    });
  std::stable_sort(explanation.evidence.begin(), explanation.evidence.end(),
                   [](const PlaceEvidence& a, const PlaceEvidence& b) { return a.stamp_ns > b.stamp_ns; });
  return explanation;
}

std::vector<PlaceEvidence> Mapper::State::evidence_about(const Eigen::Vector3d& place_map_m,
                                                         const ScanView& view) const {
  std::vector<PlaceEvidence> of_levels;
  const Spherical seen = spherical(view.to_sensor(place_map_m));
  for (std::size_t r = 0; r < models.size(); ++r) {
    PlaceEvidence evidence;
    evidence.stamp_ns = view.stamp_ns;
    evidence.origin_map_m = view.origin_map_m;
    evidence.level_deg = parameters.angular_levels_deg[r];
    evidence.range_m = seen.range_m;
    evidence.measured = view.levels()[r].at(seen.azimuth_rad, seen.elevation_rad);
    evidence.kind = classify(seen.range_m, evidence.measured, models[r]);
    evidence.conflict_above_m = models[r].tau_m(seen.range_m);
    of_levels.push_back(evidence);
  }
  return of_levels;
}

}  // namespace stillmap
