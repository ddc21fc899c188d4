#include "doctor/ray_origin.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

#include "stillmap/projection.hpp"

namespace stillmap {
namespace {

constexpr float kDegree = 0.01745329252F;
constexpr float kReach_m = 1.5F, kCoarse_m = 0.04F, kFine_m = 0.01F;
constexpr double kSharper = 1.6,
                 kSharp = 0.0025;  // the seven simulated sensors with rings reach 0.0028 and more
// The lasers of an HDL-64 themselves lie 0.2 m from the origin of its clouds.
constexpr float kWorthTelling_m = 0.24F;
constexpr std::size_t kPoints = 6000;

std::vector<Eigen::Vector3f> some_returns(const Scan& scan) {
  constexpr float kNearest_m = 2.0F, kFarthest_m = 60.0F;
  std::vector<Eigen::Vector3f> points;
  const std::size_t step = scan.points.size() / kPoints + 1;
  for (std::size_t i = 0; i < scan.points.size(); i += step) {
    const float range_m = scan.points[i].norm();
    if (range_m > kNearest_m && range_m < kFarthest_m) points.push_back(scan.points[i]);
  }
  return points;
}

/// How likely two returns have the same elevation, seen from `origin`. Level planes are left out: seen from
/// within one, all of it has the same elevation.
double ring_sharpness(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& origin) {
  constexpr float kBin = 0.04F * kDegree, kLevel = 2.0F * kDegree, kSteepest = 60.0F * kDegree;
  std::vector<int> bins(static_cast<std::size_t>(2 * kSteepest / kBin) + 1, 0);
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f ray = point - origin;
    const float elevation = fast_atan2(ray.z(), std::hypot(ray.x(), ray.y()));
    if (std::abs(elevation) > kLevel && std::abs(elevation) < kSteepest)
      ++bins[static_cast<std::size_t>((elevation + kSteepest) / kBin)];
  }
  double pairs = 0;
  for (const int count : bins) pairs += double(count) * (count - 1);
  return pairs / (double(points.size()) * double(points.size()));
}

/// Axis by axis, height first: it moves the rings most.
Eigen::Vector3f sharpest_origin(const std::vector<Eigen::Vector3f>& points) {
  Eigen::Vector3f best = Eigen::Vector3f::Zero();
  double sharpness = ring_sharpness(points, best);
  const auto search = [&](int axis, float from_m, float to_m, float step_m) {
    const Eigen::Vector3f start = best;
    for (float at = from_m; at <= to_m; at += step_m) {
      Eigen::Vector3f origin = start;
      origin[axis] += at;
      const double found = ring_sharpness(points, origin);
      if (found > sharpness) best = origin, sharpness = found;
    }
  };
  for (int round = 0; round < 2; ++round)
    for (const int axis : {2, 0, 1}) search(axis, -kReach_m - best[axis], kReach_m - best[axis], kCoarse_m);
  for (const int axis : {2, 0, 1}) search(axis, -kCoarse_m, kCoarse_m, kFine_m);
  return best;
}

std::string sensor_on_body(const Eigen::Isometry3d& T_body_sensor) {
  const Eigen::Vector3d t = T_body_sensor.translation();
  const Eigen::Quaterniond q(T_body_sensor.linear());
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << t.x() << ' ' << t.y() << ' ' << t.z() << ' ';
  if (q.angularDistance(Eigen::Quaterniond::Identity()) < 1e-3)
    text << "0 0 0";
  else
    text << std::setprecision(4) << q.x() << ' ' << q.y() << ' ' << q.z() << ' ' << q.w();
  return text.str();
}

}  // namespace

std::optional<Finding> check_ray_origin(const Scan& scan, const PairingOptions& said) {
  const std::vector<Eigen::Vector3f> points = some_returns(scan);
  if (points.size() < kPoints / 10) return std::nullopt;
  const Eigen::Vector3f origin = sharpest_origin(points);
  const double sharpness = ring_sharpness(points, origin);
  if (origin.norm() < kWorthTelling_m || sharpness < kSharp ||
      sharpness < kSharper * ring_sharpness(points, Eigen::Vector3f::Zero()))
    return std::nullopt;
  const std::string place = sensor_on_body(said.T_body_sensor * Eigen::Translation3d(origin.cast<double>()));
  std::map<std::string, std::string> mend = {{"sensor_on_body", place}};
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "the rays start " << origin.norm()
       << " m from where they are taken to, which puts returns behind walls; set sensor_on_body to \""
       << place << '"';
  if (said.cloud_frame == CloudFrame::kSensor) {
    text << " and cloud_frame to body";
    mend["cloud_frame"] = "body";
  }
  return Finding{"origin", text.str(), mend};
}

}  // namespace stillmap
