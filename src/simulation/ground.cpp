#include "simulation/ground.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/random.hpp"

namespace stillmap::simulation {
namespace {

/// The part of the ray above the patch's rectangle, within [0, max_range_m]. False where there is none.
bool clip_to_rectangle(const Ray& ray, const GroundPatch& patch, double* enter, double* leave) {
  for (int axis = 0; axis < 2; ++axis) {
    const double direction = ray.direction[axis];
    if (std::abs(direction) < 1e-12) {
      if (ray.origin[axis] < patch.min[axis] || ray.origin[axis] > patch.max[axis]) return false;
      continue;
    }
    const double to_min = (patch.min[axis] - ray.origin[axis]) / direction;
    const double to_max = (patch.max[axis] - ray.origin[axis]) / direction;
    *enter = std::max(*enter, std::min(to_min, to_max));
    *leave = std::min(*leave, std::max(to_min, to_max));
  }
  return *enter < *leave;
}

/// Height of a blade of grass or a pebble: the same whenever the place is looked at.
double blade_height_m(const Eigen::Vector3d& at, double roughness_m) {
  constexpr double kCell_m = 0.06;
  const auto x = static_cast<std::int64_t>(std::floor(at.x() / kCell_m));
  const auto y = static_cast<std::int64_t>(std::floor(at.y() / kCell_m));
  return roughness_m * Random(17, static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y)).uniform();
}

}  // namespace

double Ground::bare_height_m(double x, double y) const {
  double height = slope.x() * x + slope.y() * y;
  for (const GroundWave& wave : waves) {
    height +=
        wave.amplitude_m * std::sin(wave.wave_vector.x() * x + wave.wave_vector.y() * y + wave.phase_rad);
  }
  return height;
}

double Ground::height_m(double x, double y) const {
  std::optional<double> highest;
  for (const GroundPatch& patch : patches) {
    const bool inside = x >= patch.min.x() && x <= patch.max.x() && y >= patch.min.y() && y <= patch.max.y();
    if (inside) highest = std::max(highest.value_or(patch.height_m), patch.height_m);
  }
  return bare_height_m(x, y) + highest.value_or(0.0);
}

double Ground::steepest_slope() const {
  double slope_sum = slope.norm();
  for (const GroundWave& wave : waves) slope_sum += wave.amplitude_m * wave.wave_vector.norm();
  return slope_sum;
}

std::optional<double> Ground::cross_patch(const Ray& ray, const GroundPatch& patch,
                                          double max_range_m) const {
  double range_m = 0, leave = max_range_m;
  if (!clip_to_rectangle(ray, patch, &range_m, &leave)) return std::nullopt;
  // The gap between ray and ground closes at most this fast, so stepping gap / closing never steps through.
  const double closing = steepest_slope() * ray.direction.head<2>().norm() - ray.direction.z();
  if (closing <= 0) return std::nullopt;
  constexpr int kMaxSteps = 80;
  constexpr double kTouching_m = 1e-3;
  for (int step = 0; step < kMaxSteps && range_m <= leave; ++step) {
    const Eigen::Vector3d at = ray.origin + range_m * ray.direction;
    const double gap_m = at.z() - bare_height_m(at.x(), at.y()) - patch.height_m;
    if (gap_m < -kTouching_m && step == 0) return std::nullopt;  // comes in from below the patch's edge
    if (gap_m < kTouching_m) return range_m;
    range_m += gap_m / closing;
  }
  return std::nullopt;
}

std::optional<GroundCrossing> Ground::cross(const Ray& ray, double max_range_m) const {
  std::optional<GroundCrossing> nearest;
  double limit_m = max_range_m;
  for (const GroundPatch& patch : patches) {
    const auto range_m = cross_patch(ray, patch, limit_m + 1e-3);
    if (!range_m) continue;
    limit_m = std::min(limit_m, *range_m);
    nearest = GroundCrossing{{*range_m, std::abs(ray.direction.z())}, patch.surface};
  }
  if (nearest && nearest->surface.roughness_m > 0) {
    const Eigen::Vector3d at = ray.origin + nearest->crossing.range_m * ray.direction;
    const double steepness = std::max(0.1, nearest->crossing.incidence_cos);
    nearest->crossing.range_m -=
        std::min(nearest->crossing.range_m / 2, blade_height_m(at, nearest->surface.roughness_m) / steepness);
    nearest->crossing.incidence_cos = std::max(0.4, nearest->crossing.incidence_cos);  // blades stand up
  }
  return nearest;
}

}  // namespace stillmap::simulation
