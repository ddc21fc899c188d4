#pragma once

#include "simulation/random.hpp"
#include "simulation/world.hpp"

namespace stillmap::simulation {

// What is built. All of it stands on the world's ground, so that must be laid first.

/// A house front along +x from `corner`, with windows set back into the wall; depth grows to `side` (+1 or
/// -1) along y.
void add_house(World* world, const Eigen::Vector2d& corner, double width_m, double depth_m, double height_m,
               int side, Random* random);
/// A wall between two points, from the ground (or `from_height_m` above it) up.
void add_wall(World* world, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double thickness_m,
              double height_m, const Surface& surface, double from_height_m = 0);
/// Posts and rails; rays pass between.
void add_fence(World* world, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height_m);
void add_guard_rail(World* world, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
/// Along the edge of a patch that lies `height_m` above the bare ground.
void add_kerb(World* world, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height_m);
void add_pole(World* world, const Eigen::Vector2d& at, double radius_m, double height_m);
void add_sign(World* world, const Eigen::Vector2d& at, double facing_rad);
void add_wire(World* world, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double sag_m);
void add_column(World* world, const Eigen::Vector2d& at, double radius_m, double height_m);
void add_bench(World* world, const Eigen::Vector2d& at, double yaw_rad);
void add_table(World* world, const Eigen::Vector2d& at, double yaw_rad);

}  // namespace stillmap::simulation
