#include <cmath>

#include "simulation/plants.hpp"
#include "simulation/scene.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector2d;

constexpr double kLane_m = 3.7, kMedian_m = 2.5, kShoulder_m = 2.8;
constexpr int kLanes = 3;
constexpr double kOuter_m = kMedian_m + kLanes * kLane_m + kShoulder_m;

/// The middle of lane 0 (fastest) to 2, on the side of the road where y has this sign.
double lane_y(int side, int lane) {
  return side * (kMedian_m + (lane + 0.5) * kLane_m);
}

void build_road(World* world, double from_m, double to_m, Random* random) {
  world->ground.slope = {random->uniform(-0.02, 0.02), 0};
  world->ground.waves = {{{0.015, 0}, 0.5, random->uniform(0, 6)}};
  world->add_ground(-0.05, surfaces::kGrass);
  world->ground.patches.push_back({{-2000, -kOuter_m}, {to_m + 2000, kOuter_m}, 0, surfaces::kRoad});
  for (const double y : {-kOuter_m - 0.6, -1.0, 1.0, kOuter_m + 0.6}) {
    add_guard_rail(world, {from_m, y}, {to_m, y});
  }
}

void furnish_verge(World* world, double from_m, double to_m, Random* random) {
  for (double x = from_m; x < to_m; x += random->uniform(40, 60)) {  // marker posts
    for (const int side : {-1, 1}) add_pole(world, {x, side * (kOuter_m + 0.3)}, 0.06, 1.0);
  }
  const double gantry_m = random->uniform(40, 120);
  for (double x = gantry_m; x < to_m; x += random->uniform(150, 260)) {
    for (const int side : {-1, 1}) add_pole(world, {x, side * (kOuter_m + 1.2)}, 0.2, 6.5);
    world->add_box(pose_at(x, 0, world->ground.height_m(x, 0) + 6.2), {0.4, 2 * kOuter_m + 2.4, 0.5},
                   surfaces::kPole);
    world->add_box(pose_at(x - 0.3, lane_y(-1, 1), world->ground.height_m(x, 0) + 6.6), {0.05, 5, 2.2},
                   surfaces::kSign);
  }
  const double noise_wall_m = random->uniform(20, 100), wall_y = kOuter_m + 4;
  for (double x = noise_wall_m; x < noise_wall_m + 120; x += 6) {
    add_wall(world, {x, wall_y}, {x + 6, wall_y}, 0.25, 4, surfaces::kFacade);
  }
  for (double x = from_m; x < to_m; x += random->uniform(8, 22)) {
    const double y = -kOuter_m - random->uniform(5, 16);
    if (random->chance(0.6)) {
      add_tree(world, {x, y}, random->uniform(5, 9), random);
    } else {
      add_bush(world, {x, y}, random->uniform(0.7, 1.5), random);
    }
  }
}

void add_traffic(World* world, double from_m, double to_m, const SceneOptions& options, Random* random) {
  constexpr double kTruckShares[kLanes] = {0.0, 0.1, 0.6};
  for (int lane = 0; lane < kLanes; ++lane) {
    const double speed_mps = 33.0 - 5.0 * lane + random->uniform(-1.5, 1.5);
    const double away_y = lane_y(1, lane), own_y = lane_y(-1, lane);
    add_lane_traffic(world, {{to_m, away_y}, {from_m, away_y}, speed_mps, 60, kTruckShares[lane]},
                     options.duration_s, random);
    if (lane == 1) continue;  // our own, below
    add_lane_traffic(world, {{from_m, own_y}, {to_m, own_y}, speed_mps, 60, kTruckShares[lane]},
                     options.duration_s, random);
  }
  const Path own_lane({{-200, lane_y(-1, 1)}, {to_m + 300, lane_y(-1, 1)}});
  for (const double ahead_m : {random->uniform(22, 35), random->uniform(70, 90), -random->uniform(20, 30)}) {
    add_car(world, own_lane, SpeedProfile::constant(options.ego_speed_mps), random, 200 + ahead_m);
  }
}

}  // namespace

Scene make_highway(const SceneOptions& options) {
  Scene scene;
  Random random(options.seed, 6);
  const double way_m = options.ego_speed_mps * options.duration_s, from_m = -120, to_m = way_m + 140;
  build_road(&scene.world, from_m, to_m, &random);
  furnish_verge(&scene.world, from_m, to_m, &random);
  add_traffic(&scene.world, from_m, to_m, options, &random);
  const Path path({{-50, lane_y(-1, 1)}, {way_m + 100, lane_y(-1, 1)}});
  scene.T_map_sensor_at = carried(path, SpeedProfile::constant(options.ego_speed_mps), scene.world.ground,
                                  {1.8, 0.1, kCarWheelbase_m, 50});
  return scene;
}

}  // namespace stillmap::simulation
