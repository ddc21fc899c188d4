#include <cmath>

#include "simulation/plants.hpp"
#include "simulation/scene.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector2d;

constexpr double kRowPitch_m = 4.2, kTreePitch_m = 2.3;
constexpr int kRowsEachSide = 5;

void lay_ground(World* world, Random* random) {
  world->ground.slope = {random->uniform(-0.02, 0.02), random->uniform(-0.03, 0.03)};
  world->ground.waves = {{{0.11, 0.07}, 0.08, random->uniform(0, 6)},
                         {{0.9, 1.7}, 0.02, random->uniform(0, 6)}};
  world->add_ground(0, surfaces::kGrass);
}

void plant_row(World* world, double y, double from_m, double to_m, Random* random) {
  for (double x = from_m; x < to_m; x += kTreePitch_m) {
    if (random->chance(0.04)) continue;  // a tree that died
    add_fruit_tree(world, {x + random->uniform(-0.15, 0.15), y + random->uniform(-0.1, 0.1)}, random);
  }
  constexpr double kPostPitch_m = 11.5, kPostHeight_m = 2.4;
  for (double x = from_m - 1; x < to_m; x += kPostPitch_m) {
    add_pole(world, {x, y}, 0.05, kPostHeight_m);
    const auto top = [&](double at) {
      return Eigen::Vector3d(at, y, world->ground.height_m(at, y) + kPostHeight_m - 0.2);
    };
    if (x + kPostPitch_m < to_m) add_wire(world, top(x), top(x + kPostPitch_m), 0.05);
  }
}

void add_workers(World* world, double way_m, double duration_s, Random* random) {
  const int crossers = random->integer(1, 3);
  for (int i = 0; i < crossers; ++i) {  // between two trees, from lane to lane
    const double x = kTreePitch_m * (std::floor(random->uniform(2, 6 + way_m / kTreePitch_m)) + 0.5);
    const double side = random->chance(0.5) ? -1 : 1;
    const Path path({{x, side * 10}, {x, side * -10}, {x, side * 10}, {x, side * -10}});
    add_person(world, path, SpeedProfile::constant(random->uniform(0.7, 1.4)), random, random->uniform(0, 8));
  }
  for (const double lane : {0.0, kRowPitch_m, -kRowPitch_m}) {  // along the lanes, one of them ahead of us
    const double x = random->uniform(4, 9), y = lane + random->uniform(-0.4, 0.4);
    add_person(world, Path({{x, y}, {x + 300, y}}), some_walk(duration_s, random), random);
  }
  const double x = random->uniform(8, 14 + way_m);
  const Path late({{x, 0.9}, {x, -0.9}, {x - 3, -1.0}, {x - 60, -1.0}});
  add_person(world, late, SpeedProfile::starting(duration_s * random->uniform(0.25, 0.6), 1.1), random);
}

}  // namespace

Scene make_orchard(const SceneOptions& options) {
  Scene scene;
  Random random(options.seed, 2);
  World& world = scene.world;
  const double way_m = options.ego_speed_mps * options.duration_s;
  lay_ground(&world, &random);
  for (int row = -kRowsEachSide; row < kRowsEachSide; ++row) {
    plant_row(&world, (row + 0.5) * kRowPitch_m, -22, way_m + 32, &random);
  }
  add_house(&world, {way_m + 45, -14}, 16, 8, 5, -1, &random);
  add_fence(&world, {-30, 27}, {way_m + 40, 27}, 1.6);
  add_workers(&world, way_m, options.duration_s, &random);
  const double side = random.chance(0.5) ? -1 : 1, tractor_y = side * 2 * kRowPitch_m;
  const Path tractor_lane({{-20, tractor_y}, {way_m + 200, tractor_y}});
  add_tractor(&world, tractor_lane, SpeedProfile::constant(random.uniform(1.2, 2.2)), &random,
              random.uniform(5, 20));

  std::vector<Vector2d> points;
  for (double x = -5; x < way_m + 10; x += 1) points.emplace_back(x, 0.2 * std::sin(x / 3));
  scene.T_map_sensor_at = carried(Path(std::move(points)), SpeedProfile::constant(options.ego_speed_mps),
                                  world.ground, {1.3, 0.8, 0.8, 5});
  return scene;
}

}  // namespace stillmap::simulation
