#include "simulation/scene.hpp"

#include <stdexcept>

namespace stillmap::simulation {

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kKinds = {
      {"street", make_street, "hdl64", 100, 8.0},   {"orchard", make_orchard, "os1_64", 150, 1.0},
      {"plaza", make_plaza, "vlp16", 150, 0.8},     {"wood", make_wood, "livox", 150, 1.0},
      {"rooms", make_rooms, "os1_128", 150, 0.7},   {"highway", make_highway, "hdl64", 100, 25.0},
      {"carpark", make_carpark, "hdl32", 200, 2.0},
  };
  return kKinds;
}

const SceneKind& scene_kind(const std::string& name) {
  std::string known;
  for (const SceneKind& kind : scene_kinds()) {
    if (kind.name == name) return kind;
    known += (known.empty() ? "" : ", ") + kind.name;
  }
  throw std::invalid_argument("scene '" + name + "' is not known: use one of " + known);
}

}  // namespace stillmap::simulation
