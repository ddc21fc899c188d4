#include "simulation/plants.hpp"

#include <cmath>

namespace stillmap::simulation {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d random_direction(Random* random) {
  const double z = random->uniform(-1, 1), around = random->uniform(0, 2 * M_PI);
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(around), radius * std::sin(around), z};
}

Vector3d root_of(const World& world, const Vector2d& at) {
  return {at.x(), at.y(), world.ground.height_m(at.x(), at.y())};
}

/// From `from` upward and outward; returns its tip.
Vector3d add_branch(World* world, const Vector3d& from, double length_m, double radius_m, Random* random) {
  const double around = random->uniform(0, 2 * M_PI), rise = random->uniform(0.4, 1.2);
  const Vector3d tip = from + length_m * Vector3d(std::cos(around), std::sin(around), rise).normalized();
  world->add(make_cylinder_between(from, tip, radius_m, surfaces::kTrunk));
  return tip;
}

void add_trunk(World* world, const Vector3d& root, const Vector3d& top, double radius_m) {
  world->add(make_cylinder_between(root - Vector3d(0, 0, 0.2), top, radius_m, surfaces::kTrunk));
}

}  // namespace

void add_foliage(World* world, const Foliage& foliage, Random* random) {
  const double gust_rad = random->uniform(0, 2 * M_PI);  // leaves of a crown move much alike
  for (int i = 0; i < foliage.leaves; ++i) {
    // Denser toward the outside, where the light is.
    const double depth = std::cbrt(random->uniform(0.25, 1.0));
    const Vector3d at = foliage.center + depth * random_direction(random).cwiseProduct(foliage.semi_axes_m);
    Sway sway;
    sway.amplitude_m = static_cast<float>(foliage.sway_m * random->uniform(0.4, 1.0));
    sway.frequency_hz = static_cast<float>(random->uniform(0.4, 0.9));
    sway.phase_rad = static_cast<float>(gust_rad + random->uniform(0, 1.5));
    const double radius_m = foliage.leaf_radius_m * random->uniform(0.6, 1.2);
    world->add(make_disc(at, random_direction(random), radius_m, surfaces::kLeaf), sway);
  }
}

void add_tree(World* world, const Vector2d& at, double height_m, Random* random) {
  const Vector3d root = root_of(*world, at);
  const Vector3d lean(random->uniform(-0.3, 0.3), random->uniform(-0.3, 0.3), 0);
  const Vector3d fork = root + Vector3d(0, 0, height_m * random->uniform(0.35, 0.45)) + lean;
  add_trunk(world, root, fork, random->uniform(0.12, 0.28));
  const double crown_m = height_m * random->uniform(0.2, 0.28);
  for (int i = 0; i < 5; ++i) {
    const Vector3d tip = add_branch(world, fork, height_m * 0.28, 0.05, random);
    add_foliage(world, {tip, {crown_m, crown_m, crown_m * 0.8}, 260, 0.11, 0.06}, random);
  }
}

void add_fruit_tree(World* world, const Vector2d& at, Random* random) {
  const Vector3d root = root_of(*world, at);
  const double height_m = random->uniform(2.6, 3.6);
  const Vector3d fork = root + Vector3d(random->uniform(-0.1, 0.1), random->uniform(-0.1, 0.1), 1.0);
  add_trunk(world, root, fork, random->uniform(0.06, 0.11));
  for (int i = 0; i < 5; ++i) {
    const Vector3d tip = add_branch(world, fork, height_m * 0.33, 0.03, random);
    const double crown_m = random->uniform(0.5, 0.75);
    add_foliage(world, {tip, {crown_m, crown_m, crown_m}, 80, 0.06, random->uniform(0.02, 0.09)}, random);
  }
}

void add_forest_trunk(World* world, const Vector2d& at, Random* random) {
  const Vector3d root = root_of(*world, at);
  const double height_m = random->uniform(10, 18);
  const Vector3d top =
      root + Vector3d(random->uniform(-0.6, 0.6), random->uniform(-0.6, 0.6), height_m * 0.75);
  add_trunk(world, root, top, random->uniform(0.08, 0.3));
  for (int i = 0; i < 4; ++i) {  // dead twigs
    add_branch(world, root + random->uniform(0.15, 0.6) * (top - root), random->uniform(0.4, 1.4), 0.015,
               random);
  }
  const double crown_m = random->uniform(1.2, 2.2);
  add_foliage(world, {top, {crown_m, crown_m, height_m * 0.25}, 260, 0.12, 0.12}, random);
}

void add_bush(World* world, const Vector2d& at, double radius_m, Random* random) {
  const Vector3d center = root_of(*world, at) + Vector3d(0, 0, radius_m * 0.7);
  const int leaves = static_cast<int>(350 * radius_m * radius_m) + 40;
  add_foliage(world, {center, Vector3d(radius_m, radius_m, radius_m * 0.8), leaves, 0.06, 0.03}, random);
}

void add_fern(World* world, const Vector2d& at, Random* random) {
  const Vector3d root = root_of(*world, at);
  const double height_m = random->uniform(0.3, 0.8);
  add_foliage(world, {root + Vector3d(0, 0, height_m * 0.6), {0.5, 0.5, height_m * 0.5}, 45, 0.07, 0.03},
              random);
}

void add_hedge(World* world, const Vector2d& from, const Vector2d& to, double height_m, Random* random) {
  constexpr double kStep_m = 0.6;
  const int steps = static_cast<int>((to - from).norm() / kStep_m);
  for (int i = 0; i <= steps; ++i) {
    const Vector2d at = from + (to - from) * (static_cast<double>(i) / std::max(1, steps));
    const Vector3d center = root_of(*world, at) + Vector3d(0, 0, height_m / 2);
    add_foliage(world, {center, {0.5, 0.4, height_m / 2}, static_cast<int>(110 * height_m), 0.055, 0.015},
                random);
  }
}

}  // namespace stillmap::simulation
