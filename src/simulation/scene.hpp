#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/cast_scan.hpp"
#include "simulation/world.hpp"

namespace stillmap::simulation {

struct SceneOptions {
  std::uint64_t seed = 1;
  double duration_s = 10;
  double ego_speed_mps = 1;
};

/// A world and the sensor's way through it. Time 0 is the middle of the first sweep.
struct Scene {
  World world;
  SensorMotion T_map_sensor_at;
};

Scene make_street(const SceneOptions& options);
Scene make_orchard(const SceneOptions& options);
Scene make_plaza(const SceneOptions& options);
Scene make_wood(const SceneOptions& options);
Scene make_rooms(const SceneOptions& options);
Scene make_highway(const SceneOptions& options);
Scene make_carpark(const SceneOptions& options);

/// A scene and what it uses where nothing else is asked for.
struct SceneKind {
  std::string name;
  Scene (*make)(const SceneOptions&);
  std::string sensor;
  std::size_t scans;
  double ego_speed_mps;
};
const std::vector<SceneKind>& scene_kinds();
/// Throws std::invalid_argument listing the names.
const SceneKind& scene_kind(const std::string& name);

}  // namespace stillmap::simulation
