#pragma once

#include <vector>

#include "simulation/bodies.hpp"
#include "simulation/cast_scan.hpp"
#include "simulation/path.hpp"
#include "simulation/random.hpp"
#include "simulation/world.hpp"

namespace stillmap::simulation {

// Movers of the scenes, and the sensor's own way. `offset_m` = where on the path they are at time 0.

void add_person(World* world, const Path& path, const SpeedProfile& profile, Random* random,
                double offset_m = 0);
void add_car(World* world, const Path& path, const SpeedProfile& profile, Random* random,
             double offset_m = 0);
void add_truck(World* world, const Path& path, const SpeedProfile& profile, Random* random,
               double offset_m = 0);
void add_cyclist(World* world, const Path& path, const SpeedProfile& profile, Random* random,
                 double offset_m = 0);
void add_tractor(World* world, const Path& path, const SpeedProfile& profile, Random* random,
                 double offset_m = 0);
/// Stays for the whole recording.
void add_parked_car(World* world, const Eigen::Vector2d& at, double heading_rad, Random* random);
/// A door at its hinge that swings by open_rad between open_s and open_s + 2.
void add_door(World* world, const Eigen::Vector2d& hinge, double closed_rad, double open_rad, double open_s,
              double width_m, double height_m);

/// Traffic of a lane, at one speed and irregular gaps, as far as the recording can see it. Nothing is put
/// nearer than keep_clear_m to `clear_around` at time 0.
struct Lane {
  Eigen::Vector2d from, to;
  double speed_mps;
  double mean_gap_m;
  double truck_share = 0.1;
  Eigen::Vector2d clear_around = {0, 0};
  double keep_clear_m = 0;
};
void add_lane_traffic(World* world, const Lane& lane, double duration_s, Random* random);

/// Somebody's mood: walks on, stands first, stops, or goes and stands in turn.
SpeedProfile some_walk(double duration_s, Random* random);

struct Obstacle {
  Eigen::Vector2d center;
  double radius_m;
};
/// A way of at least length_m through an area, around what stands in it.
Path wander(const Eigen::AlignedBox2d& area, const std::vector<Obstacle>& obstacles, double length_m,
            Random* random);

/// What carries the sensor.
struct Carrier {
  double sensor_height_m;
  double shake_deg;
  double wheelbase_m = 0;
  double offset_m = 0;
};
SensorMotion carried(const Path& path, const SpeedProfile& profile, const Ground& ground,
                     const Carrier& carrier);

}  // namespace stillmap::simulation
