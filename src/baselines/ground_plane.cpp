#include "baselines/ground_plane.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

namespace stillmap {
namespace {

double mean_of_lowest(const std::vector<Eigen::Vector3d>& points, int count) {
  std::vector<double> heights;
  heights.reserve(points.size());
  for (const Eigen::Vector3d& point : points) heights.push_back(point.z());
  const std::size_t used = std::min(heights.size(), static_cast<std::size_t>(count));
  std::partial_sort(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(used), heights.end());
  return std::accumulate(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(used), 0.0) /
         static_cast<double>(used);
}

struct Plane {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< upwards
};

/// The normal is the direction of least spread among the points of `chosen`.
Plane fit(const std::vector<Eigen::Vector3d>& points, const std::vector<std::uint8_t>& chosen) {
  Plane plane;
  double count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (chosen[i] != 0) plane.mean += (points[i] - plane.mean) / ++count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (chosen[i] != 0) spread += (points[i] - plane.mean) * (points[i] - plane.mean).transpose();
  plane.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  if (plane.normal.z() < 0) plane.normal = -plane.normal;
  return plane;
}

}  // namespace

std::vector<std::uint8_t> find_ground(const std::vector<Eigen::Vector3d>& points,
                                      const GroundPlaneSettings& settings) {
  constexpr std::ptrdiff_t kPlanePoints = 3;
  std::vector<std::uint8_t> ground(points.size(), 1);
  if (points.size() < kPlanePoints) return ground;
  const double seed_m = mean_of_lowest(points, settings.lowest_points) + settings.seed_height_m;
  for (std::size_t i = 0; i < points.size(); ++i) ground[i] = points[i].z() < seed_m;
  for (int iteration = 0; iteration < settings.iterations; ++iteration) {
    if (std::count(ground.begin(), ground.end(), 1) < kPlanePoints) break;
    const Plane plane = fit(points, ground);
    for (std::size_t i = 0; i < points.size(); ++i)
      ground[i] = plane.normal.dot(points[i] - plane.mean) < settings.plane_distance_m;
  }
  return ground;
}

}  // namespace stillmap
