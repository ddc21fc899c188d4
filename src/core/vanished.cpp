#include <array>

#include "mapper_state.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// Where rows lie, seen from an earlier scan.
struct SeenRows {
  explicit SeenRows(std::size_t n)
      : x(n), y(n), z(n), azimuth_rad(n), elevation_rad(n), range_m(n), pixel(n) {}
  std::vector<float> x, y, z, azimuth_rad, elevation_rad, range_m;
  std::vector<int> pixel;
};

STILLMAP_VECTOR_CLONES void turn_to(std::size_t n, const float* __restrict x, const float* __restrict y,
                                    const float* __restrict z, float* __restrict azimuth_rad,
                                    float* __restrict elevation_rad, float* __restrict range_m) {
  for (std::size_t i = 0; i < n; ++i) {
    const float flat = std::sqrt(x[i] * x[i] + y[i] * y[i]);
    azimuth_rad[i] = fast_atan2(y[i], x[i]);
    elevation_rad[i] = fast_atan2(z[i], flat);
    range_m[i] = std::sqrt(flat * flat + z[i] * z[i]);
  }
}

/// All at once, so that one look into the image need not wait for another.
void see(const std::vector<Eigen::Vector3d>& points_map_m, const ScanView& from, SeenRows& seen) {
  const std::size_t n = points_map_m.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3f point_m = from.to_sensor(points_map_m[i]);
    seen.x[i] = point_m.x();
    seen.y[i] = point_m.y();
    seen.z[i] = point_m.z();
  }
  turn_to(n, seen.x.data(), seen.y.data(), seen.z.data(), seen.azimuth_rad.data(), seen.elevation_rad.data(),
          seen.range_m.data());
  from.levels().front().grid().pixels(n, seen.azimuth_rad.data(), seen.elevation_rad.data(),
                                      seen.pixel.data());
}

}  // namespace

// What stands right behind a place that a moving thing has left did not stand there before: it moved.
void Mapper::State::test_vanished(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                                  const ScanView& view) {
  const ScanHistory& history = sensors[static_cast<std::size_t>(scan.sensor)].history;
  for_each_index(runs.size(), [&](std::size_t piece) {
    std::vector<Eigen::Vector3d> points_map_m;
    std::vector<PatchRun*> run_of_point;
    for (PatchRun& run : runs[piece]) {
      if (run.votes.open() == 0 || patch_votes[run.patch].known_before()) continue;
      for (std::uint32_t i = run.first; i < run.last; ++i) {
        const std::uint32_t row = standing_rows[i];
        if (labels.label[row] != Label::kUncertain && !is_just_static(row)) continue;
        points_map_m.emplace_back(T_map_sensor * scan.points[row].cast<double>());
        run_of_point.push_back(&run);
      }
    }
    const std::vector<std::uint8_t> vanished = replaced_vanished(points_map_m, history, view);
    for (std::size_t i = 0; i < vanished.size(); ++i) run_of_point[i]->votes.add_test(vanished[i] != 0);
  });
  for (const std::vector<PatchRun>& piece : runs)
    for (const PatchRun& run : piece) {
      object_votes[run.object].add_tests(run.votes);
      patch_votes[run.patch].add_tests(run.votes);
    }
}

std::vector<std::uint8_t> Mapper::State::replaced_vanished(const std::vector<Eigen::Vector3d>& points_map_m,
                                                           const ScanHistory& history,
                                                           const ScanView& view) const {
  constexpr float kNearestM = 0.1F, kFarthestM = 3.0F;  // how far a thing moves away in a few scans
  std::vector<std::uint8_t> vanished(points_map_m.size(), 0);
  SeenRows seen(points_map_m.size());
  for (const std::size_t scans_ago : {1, 2, 4, 8}) {
    const ScanView* earlier = history.recent(scans_ago);
    if (earlier == nullptr) continue;
    see(points_map_m, *earlier, seen);
    for (std::size_t i = 0; i < points_map_m.size(); ++i) {
      if (vanished[i] != 0 || seen.pixel[i] < 0) continue;
      const MeasuredRange measured = earlier->levels().front().at(seen.pixel[i]);
      const float hidden_by_m = seen.range_m[i] - measured.farthest_m;
      if (!measured.valid() || hidden_by_m < kNearestM || hidden_by_m > kFarthestM) continue;
      const Eigen::Vector3d& origin_m = earlier->origin_map_m;
      const Eigen::Vector3d hider_map_m =
          origin_m + (points_map_m[i] - origin_m) * (measured.farthest_m / seen.range_m[i]);
      vanished[i] = view.evidence(view.to_sensor(hider_map_m), models).kind() == Evidence::kConflict;
    }
  }
  return vanished;
}

}  // namespace stillmap
