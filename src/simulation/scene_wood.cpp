#include <algorithm>
#include <cmath>

#include "simulation/plants.hpp"
#include "simulation/scene.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector2d;

constexpr double kHalfWidth_m = 22;

/// A footpath that winds through the wood.
struct Footpath {
  double bend_m, wavelength_m;

  double y(double x) const { return bend_m * std::sin(2 * M_PI * x / wavelength_m); }

  Path from_to(double from_m, double to_m, double beside_m) const {
    std::vector<Vector2d> points;
    const double step_m = from_m < to_m ? 0.5 : -0.5;
    for (double x = from_m; (to_m - x) * step_m > 0; x += step_m) points.emplace_back(x, y(x) + beside_m);
    return Path(std::move(points));
  }
};

void lay_ground(World* world, Random* random) {
  world->ground.slope = {random->uniform(-0.04, 0.04), random->uniform(-0.06, 0.06)};
  world->ground.waves = {{{0.2, 0.13}, 0.25, random->uniform(0, 6)},
                         {{-0.35, 0.5}, 0.12, random->uniform(0, 6)},
                         {{1.9, 1.1}, 0.03, random->uniform(0, 6)}};
  world->add_ground(0, surfaces::kForestFloor);
}

void plant(World* world, const Footpath& footpath, double from_m, double to_m, double crossing_m,
           Random* random) {
  constexpr double kAreaPerTrunk_m2 = 7, kClear_m = 1.1;
  const int trunks = static_cast<int>((to_m - from_m) * 2 * kHalfWidth_m / kAreaPerTrunk_m2);
  for (int i = 0; i < trunks; ++i) {
    const Vector2d at(random->uniform(from_m, to_m), random->uniform(-kHalfWidth_m, kHalfWidth_m));
    const bool is_in_the_way =
        std::abs(at.y() - footpath.y(at.x())) < kClear_m || std::abs(at.x() - crossing_m) < 0.6;
    const double what = random->uniform();
    if (what > 0.55) add_fern(world, at + Vector2d(random->uniform(-2, 2), random->uniform(-2, 2)), random);
    if (is_in_the_way) continue;
    if (what < 0.85) add_forest_trunk(world, at, random);
    if (what > 0.85) add_bush(world, at, random->uniform(0.4, 1.0), random);
  }
}

void add_walkers(World* world, const Footpath& footpath, double way_m, double crossing_m,
                 const SceneOptions& options, Random* random) {
  // One ahead at our own pace, one who stands first, some who come towards us, one across.
  const double pace_mps = std::max(0.6, options.ego_speed_mps);
  add_person(world, footpath.from_to(random->uniform(4, 7), way_m * 2 + 60, 0),
             SpeedProfile::constant(pace_mps), random);
  add_person(world, footpath.from_to(random->uniform(8, 12), -200, 0.7),
             SpeedProfile::starting(random->uniform(0.2, 0.5) * options.duration_s, 1.2), random);
  const int coming = random->integer(1, 3);
  for (int i = 0; i < coming; ++i) {
    const double from_m = random->uniform(15, 25 + way_m);
    add_person(world, footpath.from_to(from_m, -200, random->uniform(0.6, 0.8)),
               SpeedProfile::constant(random->uniform(0.9, 1.5)), random);
  }
  const Path across({{crossing_m, -kHalfWidth_m}, {crossing_m, kHalfWidth_m}});
  add_person(world, across, SpeedProfile::constant(random->uniform(0.9, 1.4)), random,
             random->uniform(5, kHalfWidth_m));
}

}  // namespace

Scene make_wood(const SceneOptions& options) {
  Scene scene;
  Random random(options.seed, 4);
  const double way_m = options.ego_speed_mps * options.duration_s;
  const Footpath footpath{random.uniform(1, 3), random.uniform(25, 45)};
  const double crossing_m = random.uniform(6, 10 + way_m);
  lay_ground(&scene.world, &random);
  plant(&scene.world, footpath, -20, way_m + 45, crossing_m, &random);
  add_walkers(&scene.world, footpath, way_m, crossing_m, options, &random);
  scene.T_map_sensor_at =
      carried(footpath.from_to(0, way_m * 1.3 + 20, 0), SpeedProfile::constant(options.ego_speed_mps),
              scene.world.ground, {1.4, 1.2});
  return scene;
}

}  // namespace stillmap::simulation
