#include <algorithm>
#include <cmath>

#include "simulation/plants.hpp"
#include "simulation/scene.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector2d;

constexpr double kSlotWidth_m = 2.6, kAisle_m = 7.0, kSlotLength_m = 5.2;
constexpr double kAislePitch_m = kAisle_m + 2 * kSlotLength_m;

/// Out of its slot and off along the aisle, ahead of the sensor's carrier or away behind it.
void add_leaving_car(World* world, const Vector2d& slot, double aisle_y, const SceneOptions& options,
                     Random* random) {
  const double leaves_s = random->uniform(0.05, 0.85) * options.duration_s;
  const double off = slot.x() > options.ego_speed_mps * leaves_s ? 1 : -1;
  const double into = aisle_y > slot.y() ? 1 : -1;
  const double drives_y = aisle_y + 1.6;
  const Path path({slot,
                   {slot.x(), drives_y - into * 2.5},
                   {slot.x() + off * 2.5, drives_y},
                   {slot.x() + off * 400, drives_y}});
  add_car(world, path, SpeedProfile::starting(leaves_s, random->uniform(2.5, 4.5)), random);
}

void fill_rows(World* world, double from_m, double to_m, const SceneOptions& options, Random* random) {
  for (const double aisle_y : {-kAislePitch_m, 0.0, kAislePitch_m}) {
    for (const double side : {-1.0, 1.0}) {
      const double y = aisle_y + side * (kAisle_m + kSlotLength_m) / 2;
      for (double x = from_m; x < to_m; x += kSlotWidth_m) {
        if (!random->chance(0.75)) continue;
        const Vector2d slot(x + random->uniform(-0.15, 0.15), y + random->uniform(-0.25, 0.25));
        const bool is_near = x > -12 && x < to_m - 20;
        if (is_near && random->chance(0.12)) {
          add_leaving_car(world, slot, aisle_y, options, random);
        } else {
          const double heading_rad = (random->chance(0.5) ? 1 : -1) * M_PI / 2 + random->uniform(-0.04, 0.04);
          add_parked_car(world, slot, heading_rad, random);
        }
      }
    }
  }
}

void furnish(World* world, double from_m, double to_m, Random* random) {
  for (double x = from_m; x < to_m; x += 22) {
    for (const double y : {-kAislePitch_m / 2, kAislePitch_m / 2}) {
      add_pole(world, {x + kSlotWidth_m / 2, y}, 0.12, 7);
      if (random->chance(0.6)) add_tree(world, {x + 11 + kSlotWidth_m / 2, y}, random->uniform(4, 6), random);
    }
  }
  const double edge_m = 1.5 * kAislePitch_m + 3;
  for (double x = from_m; x < to_m; x += 25) add_house(world, {x, edge_m}, 25, 12, 7, 1, random);
  add_hedge(world, {from_m, -edge_m}, {to_m, -edge_m}, 1.3, random);
}

void add_people(World* world, double to_m, const SceneOptions& options, Random* random) {
  const int people = random->integer(7, 14);
  for (int i = 0; i < people; ++i) {
    const double aisle_y = kAislePitch_m * random->integer(-1, 1), x = random->uniform(-15, to_m - 20);
    const double y = aisle_y + (random->chance(0.5) ? -2.8 : 2.9), ahead = random->chance(0.5) ? -1 : 1;
    add_person(world, Path({{x, y}, {x + ahead * 300, y}}), some_walk(options.duration_s, random), random);
  }
}

}  // namespace

Scene make_carpark(const SceneOptions& options) {
  Scene scene;
  Random random(options.seed, 7);
  const double way_m = options.ego_speed_mps * options.duration_s, from_m = -45, to_m = way_m + 60;
  scene.world.ground.slope = {random.uniform(-0.015, 0.015), random.uniform(-0.015, 0.015)};
  scene.world.ground.waves = {{{0.12, 0.1}, 0.05, random.uniform(0, 6)}};
  scene.world.add_ground(0, surfaces::kParking);
  fill_rows(&scene.world, from_m, to_m, options, &random);
  furnish(&scene.world, from_m, to_m, &random);
  add_people(&scene.world, to_m, options, &random);

  std::vector<Vector2d> points;
  for (double x = -20; x < way_m + 40; x += 2) points.emplace_back(x, -1.5 + 0.3 * std::sin(x / 7));
  scene.T_map_sensor_at = carried(Path(std::move(points)), SpeedProfile::constant(options.ego_speed_mps),
                                  scene.world.ground, {1.75, 0.15, kCarWheelbase_m, 20});
  return scene;
}

}  // namespace stillmap::simulation
