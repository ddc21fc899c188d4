#pragma once

#include "simulation/structures.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {

/// A yard of 30 m x 30 m with a post; crates of 1 m may stand in it.
inline MapContents session(const std::vector<Eigen::Vector2d>& crates, double voxel_size_m = 0.1) {
  World world;
  world.add_ground(0, surfaces::kRoad);
  for (const double side : {-15.0, 15.0}) {
    add_wall(&world, {-15, side}, {15, side}, 0.3, 4, surfaces::kWall);
    add_wall(&world, {side, -15}, {side, 15}, 0.3, 4, surfaces::kWall);
  }
  add_pole(&world, {5, 5}, 0.15, 3);
  for (const Eigen::Vector2d& at : crates)
    world.add_box(pose_at(at.x(), at.y(), 0.5), {1, 1, 1}, surfaces::kMetal);
  Parameters parameters;
  parameters.voxel_size_m = voxel_size_m;
  Mapper mapper(parameters);
  RunOptions options;
  options.scans = 12;
  run(
      &mapper, world, [](double time_s) { return pose_at(-4 + time_s * 6, 0, 1.5); }, options);
  return mapper.export_map();
}

}  // namespace stillmap::simulation
