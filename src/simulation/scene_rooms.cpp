#include <algorithm>
#include <cmath>

#include "simulation/scene.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector2d;

constexpr double kHalfWidth_m = 4.5, kHeight_m = 2.8, kDoorWidth_m = 1.1, kDoorHeight_m = 2.1, kWall_m = 0.14;

/// A wall across the suite at x, with a doorway at door_y.
void add_wall_with_doorway(World* world, double x, double door_y) {
  const double low = door_y - kDoorWidth_m / 2, high = door_y + kDoorWidth_m / 2;
  add_wall(world, {x, -kHalfWidth_m}, {x, low}, kWall_m, kHeight_m, surfaces::kWall);
  add_wall(world, {x, high}, {x, kHalfWidth_m}, kWall_m, kHeight_m, surfaces::kWall);
  add_wall(world, {x, low}, {x, high}, kWall_m, kHeight_m - kDoorHeight_m, surfaces::kWall, kDoorHeight_m);
}

void build_shell(World* world, double from_m, double to_m, Random* random) {
  world->add_ground(0, surfaces::kFloor);
  const double length_m = to_m - from_m, middle_m = (from_m + to_m) / 2;
  world->add_box(pose_at(middle_m, 0, kHeight_m + 0.1), {length_m, 2 * kHalfWidth_m + 0.4, 0.2},
                 surfaces::kWall);
  for (const double end : {from_m, to_m}) {
    add_wall(world, {end, -kHalfWidth_m}, {end, kHalfWidth_m}, kWall_m, kHeight_m, surfaces::kWall);
  }
  for (const double y : {-kHalfWidth_m, kHalfWidth_m}) {  // below, above and between the windows
    add_wall(world, {from_m, y}, {to_m, y}, kWall_m, 0.9, surfaces::kWall);
    add_wall(world, {from_m, y}, {to_m, y}, kWall_m, kHeight_m - 2.1, surfaces::kWall, 2.1);
    for (double x = from_m; x < to_m; x += 2.6) {
      const double pier_m = random->uniform(0.8, 1.5);
      add_wall(world, {x, y}, {std::min(x + pier_m, to_m), y}, kWall_m, 1.2, surfaces::kWall, 0.9);
      if (x + 2.6 > to_m) break;
      add_wall(world, {x + pier_m, y}, {x + 2.6, y}, 0.02, 1.2, surfaces::kPane, 0.9);
    }
  }
}

void furnish(World* world, double from_m, double to_m, Random* random) {
  for (double x = from_m + 1.6; x < to_m - 1.5; x += random->uniform(2.0, 3.2)) {
    const double side = random->chance(0.5) ? -1 : 1;
    if (random->chance(0.7))
      add_table(world, {x, side * random->uniform(2.0, 3.4)}, random->uniform(-0.3, 0.3));
    if (random->chance(0.5)) {  // a cupboard at the wall
      const double height_m = random->uniform(0.9, 2.1);
      world->add_box(pose_at(x, -side * (kHalfWidth_m - 0.35), height_m / 2), {0.9, 0.5, height_m},
                     surfaces::kFurniture);
    }
  }
}

}  // namespace

Scene make_rooms(const SceneOptions& options) {
  Scene scene;
  World& world = scene.world;
  Random random(options.seed, 5);
  const double way_m = options.ego_speed_mps * options.duration_s,
               pace_mps = std::max(0.4, options.ego_speed_mps);
  std::vector<double> walls = {-4.5};
  while (walls.back() < way_m + 9 || walls.size() < 4) walls.push_back(walls.back() + random.uniform(4.5, 7));
  build_shell(&world, walls.front(), walls.back(), &random);

  std::vector<Vector2d> way = {{walls.front() + 1, 0}};
  for (std::size_t i = 1; i + 1 < walls.size(); ++i) {
    const double door_y = random.uniform(-1.2, 1.2);
    add_wall_with_doorway(&world, walls[i], door_y);
    // Doors stand open, but one is opened while we come.
    const double hinge_y = door_y + kDoorWidth_m / 2;
    const bool opens = i == 2;
    const double opens_s = opens ? random.uniform(0.15, 0.3) * options.duration_s : kNever_s;
    add_door(&world, {walls[i] + kWall_m, hinge_y}, opens ? -M_PI / 2 : -0.2, 1.7, opens_s,
             kDoorWidth_m - 0.04, kDoorHeight_m);
    way.emplace_back(walls[i] - 0.7, door_y);
    way.emplace_back(walls[i] + 0.7, door_y);
  }
  for (std::size_t i = 0; i + 1 < walls.size(); ++i) furnish(&world, walls[i], walls[i + 1], &random);
  way.emplace_back(walls.back() - 0.8, 0);
  const Path path(way);

  const double start_m = -walls.front() - 1;  // of the path: about x = 0
  add_person(&world, path, SpeedProfile::constant(pace_mps), &random, start_m + random.uniform(2.2, 3.2));
  const int others = random.integer(2, 4);
  for (int i = 0; i < others; ++i) {
    const double x = random.uniform(-3, way_m + 6), side = random.chance(0.5) ? -1 : 1;
    const Eigen::AlignedBox2d corner(Vector2d(x - 1.2, std::min(side * 1.2, side * 3.6)),
                                     Vector2d(x + 1.2, std::max(side * 1.2, side * 3.6)));
    add_person(&world, wander(corner, {}, 2 * options.duration_s, &random),
               some_walk(options.duration_s, &random), &random);
  }
  scene.T_map_sensor_at =
      carried(path, SpeedProfile::constant(options.ego_speed_mps), world.ground, {1.0, 0.3, 0, start_m});
  return scene;
}

}  // namespace stillmap::simulation
