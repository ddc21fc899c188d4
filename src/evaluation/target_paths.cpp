#include "evaluation/target_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stillmap {
namespace {

using Eigen::Vector3d;

constexpr int kCandidates = 300;
constexpr double kNearest_m = 2.5, kFarthest_m = 12.0;  ///< start of a path, from the sensor's first place
constexpr double kPassing_m = 1.5;                      ///< between a target and the sensor or another

double flat_distance_m(const Vector3d& a, const Vector3d& b) {
  return (a - b).head<2>().norm();
}

/// Low quantile of the heights around a place; nothing where the scene has too few points.
std::optional<double> ground_height_m(const RecordedScene& scene, const Vector3d& place) {
  constexpr double kReach_m = 1.0;
  std::vector<double> heights;
  for (const Vector3d& point : scene.points)
    if (flat_distance_m(point, place) < kReach_m) heights.push_back(point.z());
  if (heights.size() < 20) return std::nullopt;
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 20);
  std::nth_element(heights.begin(), low, heights.end());
  return *low;
}

bool keeps_clear(const TargetPath& path, const RecordedScene& scene, const std::vector<TargetPath>& taken) {
  for (std::size_t k = 0; k < scene.times_s.size(); ++k) {
    const Vector3d place = path.start + scene.times_s[k] * path.velocity_mps;
    if (flat_distance_m(place, scene.sensor_places[k]) < kPassing_m) return false;
    for (const TargetPath& other : taken)
      if (flat_distance_m(place, other.start + scene.times_s[k] * other.velocity_mps) < kPassing_m)
        return false;
  }
  return true;
}

double distance_to_segment_m(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
  const Vector3d way = to - from;
  const double along = std::clamp((point - from).dot(way) / std::max(1e-9, way.squaredNorm()), 0.0, 1.0);
  return (point - from - along * way).norm();
}

/// Points where the target passes, at the height of its middle.
std::size_t points_in_the_way(const TargetPath& path, const RecordedScene& scene, const Vector3d& size_m) {
  const Vector3d middle(0, 0, 0.6 * size_m.z());
  const Vector3d from = path.start + middle, to = from + scene.times_s.back() * path.velocity_mps;
  const double reach_m = std::min(0.5 * size_m.z(), 0.5 * size_m.head<2>().norm());
  return static_cast<std::size_t>(
      std::count_if(scene.points.begin(), scene.points.end(),
                    [&](const Vector3d& point) { return distance_to_segment_m(point, from, to) < reach_m; }));
}

/// Points before the target as the sensor sees it in the first, the middle and the last scan.
std::size_t points_before_it(const TargetPath& path, const RecordedScene& scene, const Vector3d& size_m) {
  std::size_t count = 0;
  const std::size_t last = scene.times_s.size() - 1;
  for (const std::size_t k : {std::size_t{0}, last / 2, last}) {
    const Vector3d middle =
        path.start + scene.times_s[k] * path.velocity_mps + Vector3d(0, 0, 0.6 * size_m.z());
    const Vector3d towards_sensor = (scene.sensor_places[k] - middle).normalized();
    const Vector3d front = middle + 0.6 * size_m.head<2>().norm() * towards_sensor;
    for (const Vector3d& point : scene.points)
      count += distance_to_segment_m(point, scene.sensor_places[k], front) < 0.3 * size_m.z();
  }
  return count;
}

}  // namespace

TargetPath choose_path(const RecordedScene& scene, const Vector3d& size_m, double speed_mps,
                       const std::vector<TargetPath>& taken, simulation::Random& random) {
  TargetPath best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (int candidate = 0; candidate < kCandidates && least > 0; ++candidate) {
    const double distance_m = random.uniform(kNearest_m, kFarthest_m);
    const double bearing = random.uniform(-M_PI, M_PI), heading = random.uniform(-M_PI, M_PI);
    TargetPath path;
    path.start = scene.sensor_places.front() + distance_m * Vector3d(std::cos(bearing), std::sin(bearing), 0);
    path.velocity_mps = speed_mps * Vector3d(std::cos(heading), std::sin(heading), 0);
    if (!keeps_clear(path, scene, taken)) continue;
    const double duration_s = scene.times_s.back();
    const auto ground_m = ground_height_m(scene, path.start);
    const auto end_ground_m = ground_height_m(scene, path.start + duration_s * path.velocity_mps);
    if (!ground_m || !end_ground_m) continue;
    path.start.z() = *ground_m;
    if (duration_s > 0) path.velocity_mps.z() = (*end_ground_m - *ground_m) / duration_s;
    const std::size_t in_the_way =
        points_in_the_way(path, scene, size_m) + points_before_it(path, scene, size_m);
    if (in_the_way >= least) continue;
    least = in_the_way;
    best = path;
  }
  if (least == std::numeric_limits<std::size_t>::max())
    throw std::runtime_error(
        "no place for a target: no ground was measured within 12 m of the first scan's sensor; choose "
        "another part of the sequence");
  return best;
}

}  // namespace stillmap
