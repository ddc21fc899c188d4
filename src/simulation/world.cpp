#include "simulation/world.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace stillmap::simulation {

Eigen::Vector3d Sway::displacement_m(double time_s) const {
  const double angle =
      2.0 * M_PI * static_cast<double>(frequency_hz) * time_s + static_cast<double>(phase_rad);
  // Mostly along the wind, some across, at frequencies without a common period.
  return static_cast<double>(amplitude_m) *
         Eigen::Vector3d(std::sin(angle), 0.5 * std::sin(1.37 * angle + 1.0), 0.3 * std::sin(1.71 * angle));
}

void World::add(const Shape& shape, const Sway& sway, std::uint16_t instance) {
  fixtures_.push_back({shape, sway, instance});
}

void World::add_box(const Eigen::Isometry3d& T_map_box, const Eigen::Vector3d& size_m,
                    const Surface& surface) {
  add(make_box(T_map_box, size_m, surface));
}

void World::add_cylinder(const Eigen::Isometry3d& T_map_cylinder, double radius_m, double height_m,
                         const Surface& surface) {
  add(make_cylinder(T_map_cylinder, radius_m, height_m, surface));
}

void World::add_ground(double height_m, const Surface& surface) {
  constexpr double kFar_m = 1e5;
  ground.patches.push_back({{-kFar_m, -kFar_m}, {kFar_m, kFar_m}, height_m, surface});
}

void World::add_standing(const Body& body, const Eigen::Isometry3d& T_map_body) {
  const std::uint16_t instance = next_instance();
  for (const Part& part : body) {
    Shape shape = part.shape;
    shape.center = T_map_body * shape.center;
    shape.R_parent_shape = T_map_body.linear() * shape.R_parent_shape;
    add(shape, {}, instance);
  }
}

std::uint16_t World::add_mover(Mover mover) {
  mover.instance = next_instance();
  movers_.push_back(std::move(mover));
  return movers_.back().instance;
}

std::uint16_t World::next_instance() {
  if (instance_count_ == std::numeric_limits<std::uint16_t>::max()) {
    throw std::invalid_argument("the simulated world holds more than 65535 instances: make it smaller");
  }
  return ++instance_count_;
}

}  // namespace stillmap::simulation
