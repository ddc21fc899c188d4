#include "simulation/traffic.hpp"

#include <algorithm>
#include <cmath>

namespace stillmap::simulation {
namespace {

void add(World* world, Body body, const Path& path, const SpeedProfile& profile, double offset_m,
         double wheelbase_m, std::uint16_t class_moving, std::uint16_t class_standing) {
  Mover mover;
  mover.body = std::move(body);
  mover.motion = along(path, profile, world->ground, offset_m, wheelbase_m);
  mover.first_move_s = profile.first_move_s();
  mover.class_moving = class_moving;
  mover.class_standing = class_standing;
  world->add_mover(std::move(mover));
}

bool is_clear(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
              const std::vector<Obstacle>& obstacles) {
  return std::all_of(obstacles.begin(), obstacles.end(), [&](const Obstacle& obstacle) {
    const Eigen::Vector2d way = to - from;
    const double share =
        std::clamp((obstacle.center - from).dot(way) / std::max(1e-9, way.squaredNorm()), 0.0, 1.0);
    return (from + share * way - obstacle.center).norm() > obstacle.radius_m;
  });
}

}  // namespace

void add_person(World* world, const Path& path, const SpeedProfile& profile, Random* random,
                double offset_m) {
  add(world, person_body(random), path, profile, offset_m, 0, kMovingPerson, kPerson);
}

void add_car(World* world, const Path& path, const SpeedProfile& profile, Random* random, double offset_m) {
  add(world, car_body(random), path, profile, offset_m, kCarWheelbase_m, kMovingCar, kCar);
}

void add_truck(World* world, const Path& path, const SpeedProfile& profile, Random* random, double offset_m) {
  add(world, truck_body(random), path, profile, offset_m, kTruckWheelbase_m, kMovingTruck, kTruck);
}

void add_cyclist(World* world, const Path& path, const SpeedProfile& profile, Random* random,
                 double offset_m) {
  add(world, cyclist_body(random), path, profile, offset_m, 1.0, kMovingBicyclist, kBicyclist);
}

void add_tractor(World* world, const Path& path, const SpeedProfile& profile, Random* random,
                 double offset_m) {
  add(world, tractor_body(random), path, profile, offset_m, 1.8, kMovingOther, kOtherVehicle);
}

void add_parked_car(World* world, const Eigen::Vector2d& at, double heading_rad, Random* random) {
  world->add_standing(car_body(random), on_ground(world->ground, at, heading_rad, kCarWheelbase_m));
}

void add_door(World* world, const Eigen::Vector2d& hinge, double closed_rad, double open_rad, double open_s,
              double width_m, double height_m) {
  Mover door;
  door.body = door_body(width_m, height_m);
  const double ground_m = world->ground.height_m(hinge.x(), hinge.y());
  door.motion = [=](double time_s) {
    constexpr double kOpening_s = 2;
    const double share = std::clamp((time_s - open_s) / kOpening_s, 0.0, 1.0);
    return MoverPose{pose_at(hinge.x(), hinge.y(), ground_m, closed_rad + share * open_rad), 0};
  };
  door.first_move_s = open_s;
  door.class_moving = kMovingOther;
  door.class_standing = kOther;
  world->add_mover(std::move(door));
}

void add_lane_traffic(World* world, const Lane& lane, double duration_s, Random* random) {
  const Eigen::Vector2d direction = (lane.to - lane.from).normalized();
  const double behind_m = lane.speed_mps * duration_s;  // who comes into sight during the recording
  const double length_m = (lane.to - lane.from).norm();
  const Path path({lane.from - direction * behind_m, lane.to + direction * behind_m});
  for (double at_m = random->uniform(0, lane.mean_gap_m); at_m < length_m + behind_m;
       at_m += random->uniform(0.5, 1.5) * lane.mean_gap_m + 9) {
    if ((path.position(at_m) - lane.clear_around).norm() < lane.keep_clear_m) continue;
    const auto add_vehicle = random->chance(lane.truck_share) ? add_truck : add_car;
    add_vehicle(world, path, SpeedProfile::constant(lane.speed_mps), random, at_m);
  }
}

SpeedProfile some_walk(double duration_s, Random* random) {
  const double speed_mps = random->uniform(0.8, 1.7), mood = random->uniform();
  if (mood < 0.5) return SpeedProfile::constant(speed_mps);
  if (mood < 0.7) return SpeedProfile::starting(random->uniform(0.15, 0.7) * duration_s, speed_mps);
  if (mood < 0.85) return SpeedProfile::stopping(random->uniform(0.2, 0.7) * duration_s, speed_mps);
  return SpeedProfile::stop_and_go(random->uniform(2, 5), random->uniform(1, 4), speed_mps,
                                   random->uniform(-3, 3));
}

Path wander(const Eigen::AlignedBox2d& area, const std::vector<Obstacle>& obstacles, double length_m,
            Random* random) {
  constexpr int kTries = 200;
  const auto somewhere = [&] {
    return Eigen::Vector2d(random->uniform(area.min().x(), area.max().x()),
                           random->uniform(area.min().y(), area.max().y()));
  };
  std::vector<Eigen::Vector2d> points = {somewhere()};
  for (int i = 0; i < kTries && !is_clear(points[0], points[0], obstacles); ++i) points[0] = somewhere();
  double so_far_m = 0;
  while (so_far_m < length_m) {
    Eigen::Vector2d next = somewhere();
    for (int i = 0; i < kTries && !is_clear(points.back(), next, obstacles); ++i) next = somewhere();
    so_far_m += (next - points.back()).norm();
    points.push_back(next);
  }
  return Path(std::move(points));
}

SensorMotion carried(const Path& path, const SpeedProfile& profile, const Ground& ground,
                     const Carrier& carrier) {
  const auto motion = along(path, profile, ground, carrier.offset_m, carrier.wheelbase_m);
  const double shake_rad = carrier.shake_deg * M_PI / 180.0;
  return [motion, height_m = carrier.sensor_height_m, shake_rad](double time_s) {
    // Nobody shakes while standing still: the shaking follows the way, not the time.
    const MoverPose foot = motion(time_s);
    Eigen::Isometry3d T_map_sensor = foot.T_map_body;
    T_map_sensor.translate(Eigen::Vector3d(0, 0, height_m + shake_rad * std::sin(2.9 * foot.distance_m)));
    T_map_sensor.rotate(
        Eigen::AngleAxisd(shake_rad * std::sin(1.7 * foot.distance_m), Eigen::Vector3d::UnitY()) *
        Eigen::AngleAxisd(shake_rad * std::sin(1.1 * foot.distance_m + 1), Eigen::Vector3d::UnitX()));
    return T_map_sensor;
  };
}

}  // namespace stillmap::simulation
