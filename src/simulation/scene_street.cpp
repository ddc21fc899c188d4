#include <algorithm>
#include <cmath>

#include "simulation/plants.hpp"
#include "simulation/scene.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector2d;

constexpr double kRoadHalf_m = 5.8, kSidewalk_m = 2.8, kSidewalkHeight_m = 0.15, kKerbHeight_m = 0.12;
constexpr double kLane_m = 1.75, kCycleLane_m = 3.25, kParking_m = 4.85;

/// What the parts of the street need to know of each other.
struct Street {
  World* world;
  Random* random;
  SceneOptions options;
  double from_m, to_m;  ///< of the built-up stretch, along x
};

void lay_ground(const Street& street) {
  Ground& ground = street.world->ground;
  ground.slope = {street.random->uniform(-0.015, 0.015), street.random->uniform(-0.004, 0.004)};
  ground.waves = {{{0.04, 0.01}, 0.25, street.random->uniform(0, 6)},
                  {{0.9, 0.5}, 0.008, street.random->uniform(0, 6)},
                  {{0.3, 1.3}, 0.006, street.random->uniform(0, 6)}};
  street.world->add_ground(0.02, surfaces::kGrass);
  // Road and sidewalks lie over the grass.
  const double far_m = street.to_m + 500;
  ground.patches.push_back(
      {{-500, -kRoadHalf_m}, {far_m, kRoadHalf_m}, kSidewalkHeight_m - kKerbHeight_m, surfaces::kRoad});
  for (const double y : {-kRoadHalf_m - kSidewalk_m, kRoadHalf_m}) {
    ground.patches.push_back({{-500, y}, {far_m, y + kSidewalk_m}, kSidewalkHeight_m, surfaces::kSidewalk});
  }
}

void build_houses(const Street& street, int side) {
  Random& random = *street.random;
  for (double x = street.from_m; x < street.to_m;) {
    const double width_m = random.uniform(8, 18),
                 front_m = kRoadHalf_m + kSidewalk_m + random.uniform(0.3, 4);
    const double gap_m = random.chance(0.4) ? random.uniform(2, 9) : 0.0;
    add_house(street.world, {x, side * front_m}, width_m, 10, random.uniform(5, 14), side, &random);
    const double border_m = kRoadHalf_m + kSidewalk_m + 0.25;
    const Vector2d from(x + width_m, side * border_m), to(x + width_m + gap_m, side * border_m);
    if (gap_m > 4 && random.chance(0.5)) add_hedge(street.world, from, to, random.uniform(1.0, 1.9), &random);
    if (gap_m > 4 && random.chance(0.4)) add_fence(street.world, from, to, 1.2);
    if (gap_m > 5) add_tree(street.world, (from + to) / 2 + Vector2d(0, side * 3.0), 6, &random);
    x += width_m + gap_m;
  }
}

void furnish_sidewalk(const Street& street, int side) {
  Random& random = *street.random;
  const double kerbside_m = side * (kRoadHalf_m + 0.4);
  for (double x = street.from_m; x < street.to_m; x += random.uniform(9, 20)) {
    const double what = random.uniform();
    if (what < 0.35) {
      add_tree(street.world, {x, kerbside_m + side * 0.2}, random.uniform(5, 9), &random);
    } else if (what < 0.65) {
      add_sign(street.world, {x, kerbside_m}, side > 0 ? 0 : M_PI);
    } else {
      add_pole(street.world, {x, kerbside_m}, random.uniform(0.05, 0.12), random.uniform(1.0, 6.0));
    }
  }
}

void string_wires(const Street& street) {
  constexpr double kPitch_m = 30, kHeight_m = 7.5;
  const double y = -kRoadHalf_m - 0.5;
  const auto top = [&](double x) {
    return Eigen::Vector3d(x, y, street.world->ground.height_m(x, y) + kHeight_m);
  };
  for (double x = street.from_m; x < street.to_m; x += kPitch_m) {
    add_pole(street.world, {x, y}, 0.13, kHeight_m + 0.4);
    for (const double drop_m : {0.0, 0.4}) {
      const Eigen::Vector3d down(0, 0, drop_m);
      add_wire(street.world, top(x) - down, top(x + kPitch_m) - down, 0.6);
    }
  }
}

void park_cars(const Street& street) {
  Random& random = *street.random;
  const double leaves_near_m = street.options.ego_speed_mps * street.options.duration_s * 0.45 + 6;
  bool has_left = false;
  for (const int side : {-1, 1}) {
    for (double x = street.from_m; x < street.to_m; x += random.uniform(5.6, 6.6)) {
      if (!random.chance(0.6)) continue;
      const double y = side * kParking_m + random.uniform(-0.12, 0.12);
      if (side < 0 && !has_left && x > leaves_near_m) {
        const Path pull_out({{x, y}, {x + 4, y}, {x + 11, -kLane_m}, {x + 400, -kLane_m}});
        add_car(street.world, pull_out, SpeedProfile::starting(0.3 * street.options.duration_s, 7), &random);
        has_left = true;
        x += 6;
        continue;
      }
      const double heading_rad = (side > 0 ? M_PI : 0) + random.uniform(-0.03, 0.03);
      add_parked_car(street.world, {x, y}, heading_rad, &random);
    }
  }
}

void add_traffic(const Street& street) {
  Random& random = *street.random;
  const SceneOptions& options = street.options;
  add_lane_traffic(street.world,
                   {{street.to_m, kLane_m}, {street.from_m, kLane_m}, random.uniform(6, 11), 45, 0.15},
                   options.duration_s, &random);
  const double way_m = options.ego_speed_mps * options.duration_s;
  const Path own_lane({{-100, -kLane_m}, {way_m + 200, -kLane_m}});
  const auto own_speed = SpeedProfile::constant(options.ego_speed_mps);
  add_car(street.world, own_lane, own_speed, &random, 100 + random.uniform(12, 18));
  add_car(street.world, own_lane, own_speed, &random, 100 - random.uniform(12, 18));
  const int cyclists = random.integer(2, 4);
  for (int i = 0; i < cyclists; ++i) {
    const int side = i % 2 == 0 ? -1 : 1;
    const double x = side < 0 ? random.uniform(8, 30) : random.uniform(20, way_m + 100);
    const Path cycle_lane({{x + side * 50, side * kCycleLane_m}, {x - side * 800, side * kCycleLane_m}});
    add_cyclist(street.world, cycle_lane, SpeedProfile::constant(random.uniform(3.5, 6.5)), &random, 50);
  }
}

void add_pedestrians(const Street& street) {
  Random& random = *street.random;
  const SceneOptions& options = street.options;
  const double way_m = options.ego_speed_mps * options.duration_s;
  const int walkers = static_cast<int>((way_m + 80) / 9) + random.integer(0, 6);
  for (int i = 0; i < walkers; ++i) {
    const double side = random.chance(0.5) ? -1 : 1, x = random.uniform(-20, way_m + 60);
    const double y = side * (kRoadHalf_m + random.uniform(1.0, kSidewalk_m - 0.4));
    const double ahead = random.chance(0.5) ? -1 : 1;
    const Path path({{x, y}, {x + ahead * 400, y}});
    add_person(street.world, path, some_walk(options.duration_s, &random), &random);
  }
  // Someone crosses well ahead of the traffic.
  const double x = options.ego_speed_mps * 12 + random.uniform(5, 15), speed_mps = random.uniform(1.2, 1.7);
  const Path crossing({{x, 8}, {x + random.uniform(-2, 2), -8}, {x + 200, -7.5}});
  add_person(street.world, crossing, SpeedProfile::starting(random.uniform(0.3, 2), speed_mps), &random);
}

}  // namespace

Scene make_street(const SceneOptions& options) {
  Scene scene;
  Random random(options.seed, 1);
  const double way_m = options.ego_speed_mps * options.duration_s;
  const Street street{&scene.world, &random, options, -80, way_m + 110};
  lay_ground(street);
  for (const int side : {-1, 1}) {
    const double edge_m = side * (kRoadHalf_m + 0.07);
    add_kerb(street.world, {street.from_m, edge_m}, {street.to_m, edge_m}, kSidewalkHeight_m);
    build_houses(street, side);
    furnish_sidewalk(street, side);
  }
  string_wires(street);
  park_cars(street);
  add_traffic(street);
  add_pedestrians(street);

  const double weave_m = random.uniform(0.1, 0.3);
  std::vector<Vector2d> points;
  for (double x = -20; x < way_m + 40; x += 4) points.emplace_back(x, -kLane_m + weave_m * std::sin(x / 17));
  scene.T_map_sensor_at = carried(Path(std::move(points)), SpeedProfile::constant(options.ego_speed_mps),
                                  scene.world.ground, {1.73, 0.15, kCarWheelbase_m, 20});
  return scene;
}

}  // namespace stillmap::simulation
