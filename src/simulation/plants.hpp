#pragma once

#include "simulation/random.hpp"
#include "simulation/world.hpp"

namespace stillmap::simulation {

// What grows: clouds of small leaves that the wind moves and rays pass between.

struct Foliage {
  Eigen::Vector3d center;
  Eigen::Vector3d semi_axes_m;
  int leaves;
  double leaf_radius_m;
  double sway_m;  ///< amplitude in the wind
};

void add_foliage(World* world, const Foliage& foliage, Random* random);
/// Trunk, some branches and a crown.
void add_tree(World* world, const Eigen::Vector2d& at, double height_m, Random* random);
/// Low, with the crown starting at a metre, as they stand in an orchard.
void add_fruit_tree(World* world, const Eigen::Vector2d& at, Random* random);
/// A bare trunk with its crown out of reach, as in a dense wood.
void add_forest_trunk(World* world, const Eigen::Vector2d& at, Random* random);
void add_bush(World* world, const Eigen::Vector2d& at, double radius_m, Random* random);
void add_fern(World* world, const Eigen::Vector2d& at, Random* random);
void add_hedge(World* world, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height_m,
               Random* random);

}  // namespace stillmap::simulation
