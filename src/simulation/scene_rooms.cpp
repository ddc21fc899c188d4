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

/// Fills a room between two walls; returns what people walk around.
std::vector<Obstacle> furnish(World* world, double from_m, double to_m, Random* random) {
  std::vector<Obstacle> obstacles;
  for (double x = from_m + 1.6; x < to_m - 1.5; x += random->uniform(2.0, 3.2)) {
    const double side = random->chance(0.5) ? -1 : 1;
    if (random->chance(0.7)) {
      const Vector2d at(x, side * random->uniform(2.0, 3.4));
      add_table(world, at, random->uniform(-0.3, 0.3));
      obstacles.push_back({at, 1.2});
    }
    if (random->chance(0.5)) {  // a cupboard at the wall
      const Vector2d at(x, -side * (kHalfWidth_m - 0.35));
      const double height_m = random->uniform(0.9, 2.1);
      world->add_box(pose_at(at.x(), at.y(), height_m / 2), {0.9, 0.5, height_m}, surfaces::kFurniture);
      obstacles.push_back({at, 0.8});
    }
  }
  return obstacles;
}

/// Doors stand open, but one is opened while we come. Returns the sensor's way through all the doorways.
Path add_doors(World* world, const std::vector<double>& walls, double pace_mps, Random* random) {
  constexpr std::size_t kOpenedWall = 2;
  std::vector<Vector2d> way = {{walls.front() + 1, 0}};
  for (std::size_t i = 1; i + 1 < walls.size(); ++i) {
    const double door_y = random->uniform(-1.2, 1.2);
    add_wall_with_doorway(world, walls[i], door_y);
    const bool is_opened = i == kOpenedWall;
    const double arrival_s = (walls[i] - 3.2) / pace_mps;  // of the one who walks ahead
    const double opens_s = is_opened ? random->uniform(0.2, 0.6) * arrival_s : kNever_s;
    const Vector2d hinge(walls[i] + kWall_m, door_y + kDoorWidth_m / 2);
    add_door(world, hinge, is_opened ? -M_PI / 2 : -0.2, 1.7, opens_s, kDoorWidth_m - 0.04, kDoorHeight_m);
    way.emplace_back(walls[i] - 0.7, door_y);
    way.emplace_back(walls[i] + 0.7, door_y);
  }
  way.emplace_back(walls.back() - 0.8, 0);
  return Path(std::move(way));
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

  const Path path = add_doors(&world, walls, pace_mps, &random);
  const double start_m = -walls.front() - 1;  // of the path: about x = 0
  add_person(&world, path, SpeedProfile::constant(pace_mps), &random, start_m + random.uniform(2.2, 3.2));
  for (std::size_t i = 0; i + 1 < walls.size(); ++i) {
    const auto obstacles = furnish(&world, walls[i], walls[i + 1], &random);
    const Eigen::AlignedBox2d room(Vector2d(walls[i] + 0.6, -kHalfWidth_m + 0.6),
                                   Vector2d(walls[i + 1] - 0.6, kHalfWidth_m - 0.6));
    const int people = random.integer(0, 2);
    for (int person = 0; person < people; ++person) {
      add_person(&world, wander(room, obstacles, 2 * options.duration_s, &random),
                 some_walk(options.duration_s, &random), &random);
    }
  }
  scene.T_map_sensor_at =
      carried(path, SpeedProfile::constant(options.ego_speed_mps), world.ground, {1.0, 0.3, 0, start_m});
  return scene;
}

}  // namespace stillmap::simulation
