#include "map_points.hpp"
#include "mapper_state.hpp"

namespace stillmap {

// What stands right behind a place that a moving thing has left did not stand there before: it moved.
void Mapper::State::test_vanished(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                                  const ScanView& view) {
  const ScanHistory& history = sensors[static_cast<std::size_t>(scan.sensor)].history;
  for_each_index(runs.size(), [&](std::size_t piece) {
    MapPoints points;
    std::vector<PatchRun*> run_of_point;
    for (PatchRun& run : runs[piece]) {
      if (run.votes.open() == 0 || patch_votes[run.patch].known_before()) continue;
      for (std::uint32_t i = run.first; i < run.last; ++i) {
        const std::uint32_t row = standing_rows[i];
        if (labels.label[row] != Label::kUncertain && !is_just_static(row)) continue;
        points.add(T_map_sensor * scan.points[row].cast<double>());
        run_of_point.push_back(&run);
      }
    }
    const std::vector<std::uint8_t> vanished = replaced_vanished(points, history, view);
    for (std::size_t i = 0; i < vanished.size(); ++i) run_of_point[i]->votes.add_test(vanished[i] != 0);
  });
  for (const std::vector<PatchRun>& piece : runs)
    for (const PatchRun& run : piece) {
      object_votes[run.object].add_tests(run.votes);
      patch_votes[run.patch].add_tests(run.votes);
    }
}

std::vector<std::uint8_t> Mapper::State::replaced_vanished(MapPoints& points, const ScanHistory& history,
                                                           const ScanView& view) const {
  constexpr float kNearestM = 0.1F, kFarthestM = 3.0F;  // how far a thing moves away in a few scans
  std::vector<std::uint8_t> vanished(points.size(), 0);
  std::vector<int> pixel(points.size());
  for (const std::size_t scans_ago : {1, 2, 4, 8}) {
    const ScanView* earlier = history.recent(scans_ago);
    if (earlier == nullptr) continue;
    points.see_from(*earlier);
    const RangeImage& image = earlier->levels().front();
    image.grid().pixels(points.size(), points.azimuth_rad.data(), points.elevation_rad.data(), pixel.data());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (vanished[i] != 0 || pixel[i] < 0) continue;
      const MeasuredRange measured = image.at(pixel[i]);
      const float hidden_by_m = points.range_m[i] - measured.farthest_m;
      if (!measured.valid() || hidden_by_m < kNearestM || hidden_by_m > kFarthestM) continue;
      const Eigen::Vector3d& origin_m = earlier->origin_map_m;
      const Eigen::Vector3d hider_map_m =
          origin_m + (points[i] - origin_m) * (measured.farthest_m / points.range_m[i]);
      vanished[i] = view.evidence(view.to_sensor(hider_map_m), models).kind() == Evidence::kConflict;
    }
  }
  return vanished;
}

}  // namespace stillmap
