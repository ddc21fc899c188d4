#include <algorithm>
#include <cmath>

#include "simulation/plants.hpp"
#include "simulation/scene.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector2d;

constexpr double kHalf_m = 28;

void build_around(World* world, Random* random) {
  world->ground.slope = {random->uniform(-0.008, 0.008), random->uniform(-0.008, 0.008)};
  world->add_ground(0, surfaces::kSidewalk);
  for (const int side : {-1, 1}) {
    for (double x = -kHalf_m; x < kHalf_m - 6;) {
      const double width_m = random->uniform(9, 16);
      add_house(world, {x, side * kHalf_m}, width_m, 8, random->uniform(7, 15), side, random);
      x += width_m + (random->chance(0.3) ? 3 : 0);
    }
  }
  add_wall(world, {kHalf_m + 4, -kHalf_m}, {kHalf_m + 4, kHalf_m * 0.4}, 0.4, 9, surfaces::kFacade);
  add_fence(world, {-kHalf_m - 3, -kHalf_m}, {-kHalf_m - 3, kHalf_m}, 1.2);
}

/// Returns what people walk around.
std::vector<Obstacle> furnish(World* world, Random* random) {
  std::vector<Obstacle> obstacles = {{{0, 0}, 1.8}, {{4, 0}, 1.5}};  // the tripod and where it goes
  const int columns = random->integer(5, 8);
  for (int i = 0; i < columns; ++i) {
    const Vector2d at(-14.0 + 28.0 * i / (columns - 1), 12);
    add_column(world, at, 0.35, 6);
    obstacles.push_back({at, 0.9});
  }
  const int things = random->integer(7, 11);
  for (int i = 0; i < things; ++i) {
    const double around = random->uniform(0, 2 * M_PI), away_m = random->uniform(6, 20);
    const Vector2d at(away_m * std::cos(around), away_m * std::sin(around));
    if (i % 3 == 0) {
      add_tree(world, at, random->uniform(4.5, 7), random);
    } else if (i % 3 == 1) {
      add_bench(world, at, random->uniform(0, 2 * M_PI));
    } else {
      add_pole(world, at, 0.08, 4.5);
    }
    obstacles.push_back({at, 1.2});
  }
  return obstacles;
}

/// Groups that talk: they stand close, and some walk off in the middle of the recording.
void add_group(World* world, const Vector2d& at, double duration_s, Random* random) {
  const int people = random->integer(2, 4);
  for (int i = 0; i < people; ++i) {
    const double around = 2 * M_PI * i / people;
    const Vector2d place = at + 0.6 * Vector2d(std::cos(around), std::sin(around));
    const Vector2d away = place + 40 * Vector2d(std::cos(around + 0.3), std::sin(around + 0.3));
    const double leaves_s = random->chance(0.5) ? duration_s * random->uniform(0.3, 0.8) : kNever_s;
    const auto profile =
        leaves_s == kNever_s ? SpeedProfile::constant(0) : SpeedProfile::starting(leaves_s, 1.2);
    add_person(world, Path({place, away}), profile, random);
  }
}

}  // namespace

Scene make_plaza(const SceneOptions& options) {
  Scene scene;
  Random random(options.seed, 3);
  build_around(&scene.world, &random);
  const std::vector<Obstacle> obstacles = furnish(&scene.world, &random);
  const Eigen::AlignedBox2d area(Vector2d(-20, -20), Vector2d(20, 20));
  const int walkers = random.integer(19, 25);
  for (int i = 0; i < walkers; ++i) {
    const Path path = wander(area, obstacles, 2 * options.duration_s + 20, &random);
    add_person(&scene.world, path, some_walk(options.duration_s, &random), &random);
  }
  for (int i = 0; i < 2; ++i) {
    add_group(&scene.world, {random.uniform(5, 14) * (i == 0 ? -1 : 1), random.uniform(-12, 9)},
              options.duration_s, &random);
  }

  const Path way({{0, 0}, {4, 0.3}, {8, 2}, {30, 4}});
  const auto profile = options.ego_speed_mps > 0
                           ? SpeedProfile::starting(0.6 * options.duration_s, options.ego_speed_mps)
                           : SpeedProfile::constant(0);
  scene.T_map_sensor_at = carried(way, profile, scene.world.ground, {1.6, 0.4});
  return scene;
}

}  // namespace stillmap::simulation
