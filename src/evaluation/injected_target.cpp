#include "evaluation/injected_target.hpp"

#include <cmath>

namespace stillmap {
namespace {

using Eigen::Vector3d;
using simulation::Random;
using simulation::Ray;
using simulation::Shape;

std::uint32_t label_of(std::uint16_t semantic_class, std::uint16_t instance) {
  return semantic_class | static_cast<std::uint32_t>(instance) << 16;
}

std::optional<double> nearest_crossing(const std::vector<Shape>& shapes, const Ray& ray) {
  std::optional<double> nearest_m;
  for (const Shape& shape : shapes)
    if (const auto crossing = shape.cross(ray); crossing && (!nearest_m || crossing->range_m < *nearest_m))
      nearest_m = crossing->range_m;
  return nearest_m;
}

Vector3d inside_box(const Vector3d& size_m, Random& random) {
  return {random.uniform(-0.5, 0.5) * size_m.x(), random.uniform(-0.5, 0.5) * size_m.y(),
          random.uniform() * size_m.z()};
}

Vector3d direction(Random& random) {
  const double z = random.uniform(-1, 1), turn = random.uniform(-M_PI, M_PI), flat = std::sqrt(1 - z * z);
  return {flat * std::cos(turn), flat * std::sin(turn), z};
}

}  // namespace

Eigen::Isometry3d TargetPath::T_map_target(double time_s) const {
  const Vector3d place = start + time_s * velocity_mps;
  return simulation::pose_at(place.x(), place.y(), place.z(), std::atan2(velocity_mps.y(), velocity_mps.x()));
}

std::optional<double> InjectedTarget::range_m(const Ray& ray, double time_s) const {
  const Eigen::Isometry3d T_target_map = path.T_map_target(time_s).inverse();
  return nearest_crossing(shapes, {T_target_map * ray.origin, T_target_map.linear() * ray.direction});
}

std::vector<Vector3d> InjectedTarget::seen_from(const Vector3d& origin, double time_s, Random& random) const {
  const Eigen::Isometry3d T_map_target = path.T_map_target(time_s);
  const Vector3d eye = T_map_target.inverse() * origin;
  std::vector<Vector3d> places;
  while (places.size() < points) {  // about half of the rays into the box meet the shapes
    const Ray ray{eye, (inside_box(size_m, random) - eye).normalized()};
    if (const auto range = nearest_crossing(shapes, ray))
      places.push_back(T_map_target * (eye + *range * ray.direction));
  }
  return places;
}

std::vector<Vector3d> InjectedTarget::all_over(double time_s, Random& random) const {
  const Eigen::Isometry3d T_map_target = path.T_map_target(time_s);
  std::vector<Vector3d> places;
  while (places.size() < points) {
    const Vector3d towards = direction(random);
    const Ray ray{inside_box(size_m, random) - 2 * size_m.norm() * towards, towards};
    if (const auto range = nearest_crossing(shapes, ray))
      places.push_back(T_map_target * (ray.origin + *range * ray.direction));
  }
  return places;
}

InjectedTarget make_person_target(double height_m, std::size_t points, std::uint16_t instance) {
  const double leg_m = 0.48 * height_m, head_m = 0.075 * height_m, shoulder_m = height_m - 2.3 * head_m;
  const auto limb = [](const Vector3d& from, const Vector3d& to, double radius_m) {
    return simulation::make_cylinder_between(from, to, radius_m, simulation::surfaces::kClothes);
  };
  InjectedTarget person;
  person.shapes = {limb({0.12, 0.1, 0}, {0, 0.1, leg_m}, 0.08),
                   limb({-0.12, -0.1, 0}, {0, -0.1, leg_m}, 0.08),
                   limb({0, 0, leg_m}, {0, 0, shoulder_m}, 0.17),
                   simulation::make_ellipsoid({0, 0, height_m - head_m}, {0.1, 0.09, head_m},
                                              simulation::surfaces::kSkin)};
  person.size_m = {0.45, 0.4, height_m};
  person.label = label_of(simulation::kMovingPerson, instance);
  person.points = points;
  return person;
}

InjectedTarget make_vehicle_target(const Vector3d& size_m, std::size_t points, std::uint16_t instance) {
  InjectedTarget vehicle;
  vehicle.shapes = {simulation::make_box(simulation::pose_at(0, 0, 0.5 * size_m.z()), size_m,
                                         simulation::surfaces::kMetal)};
  vehicle.size_m = size_m;
  vehicle.label = label_of(simulation::kMovingOther, instance);
  vehicle.points = points;
  return vehicle;
}

}  // namespace stillmap
