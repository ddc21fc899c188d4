#include "evaluation/ablation.hpp"

#include <utility>

#include "evaluation/stillmap_method.hpp"
#include "io/parameters_yaml.hpp"

namespace stillmap {
namespace {

/// What takes one addition away: parameter names and values in YAML.
struct AblationSwitch {
  const char* name;
  std::vector<std::pair<const char*, const char*>> settings;
};

const std::vector<AblationSwitch>& switches() {
  static const std::vector<AblationSwitch> kSwitches = {
      {"no objects and surfaces", {{"resolve_objects", "false"}}},
      {"objects: do not follow", {{"follow_objects", "false"}}},
      {"objects: no vanish test", {{"vanish_test", "false"}}},
      {"objects: specks stay", {{"speck_size_m", "0"}}},
      {"objects: only decided points vote", {{"lean_together", "false"}}},
      {"objects: leaves go with a few of them", {{"spare_porous", "false"}}},
      {"objects: arrivals are forgotten", {{"remember_arrivals", "false"}}},
      {"objects: feet stay", {{"take_feet_along", "false"}}},
      {"objects: insides stay", {{"take_insides_along", "false"}}},
      {"beside movers nothing is doubted", {{"doubt_beside_movers", "false"}}},
      {"in the end each point for itself", {{"settle_objects_together", "false"}}},
      {"in the end a single return overrules", {{"hits_to_overrule", "0"}}},
      {"surface at the centre of its voxel", {{"surface_in_voxel", "false"}}},
      {"poses as they are given", {{"align_scans", "false"}}},
      {"conflict beside surface counts in full", {{"conflict_beside_surface", "1"}}},
      {"conflict with porous things counts in full", {{"conflict_porous", "1"}}},
      {"conflict between beams counts in full", {{"conflict_reach_voxels", "0"}}},
      {"no full support on return", {{"full_support_on_return", "false"}}},
      {"no replay of earlier scans", {{"history_recent", "0"}, {"history_spread", "0"}}},
      {"no replay chosen by place", {{"history_spread", "0"}}},
      {"replayed support of any age", {{"replay_support_min_age", "1"}}},
      {"what moved in does not have to settle", {{"settle_time_s", "0"}}},
      {"full support while dynamic", {{"support_rate_when_dynamic", "0.8"}}},
      {"one coarse image", {{"angular_levels_deg", "[2.0]"}}},
      {"the paper's three images", {{"angular_levels_deg", "[2.5, 2.0, 1.5]"}}},
      {"a hit is no support", {{"hit_is_support", "false"}}},
      {"nearest voxel of a pixel only", {{"evidence_goes_to", "nearest_voxel"}}},
      {"no forgetting", {{"forgetting", "0"}}}};
  return kSwitches;
}

MethodChoice choice(const std::string& name, const Parameters& parameters) {
  return {name, [parameters] { return std::make_unique<StillmapMethod>(parameters); }};
}

}  // namespace

std::vector<MethodChoice> ablation_choices(const Parameters& parameters) {
  std::vector<MethodChoice> choices = {choice("full", parameters)};
  for (const AblationSwitch& off : switches()) {
    Parameters without = parameters;
    for (const auto& [name, value] : off.settings) set_parameter(without, name, value);
    choices.push_back(choice(off.name, without));
  }
  return choices;
}

}  // namespace stillmap
