#pragma once

#include <string>
#include <vector>

namespace stillmap {

/// What a parameter is, beside its value; `unit` is empty for pure numbers.
struct ParameterInfo {
  const char* name;
  const char* unit;
  double min;           ///< smallest value (numbers, and each element of a list)
  double max;           ///< largest value
  const char* options;  ///< "a|b|c" for a choice; empty for a number or any text
  const char* help;     ///< meaning, with the paper's symbol
};

/// Every parameter of the method. Names, units, ranges and meanings stand once, in visit_parameters().
/// A `_r` list holds one value for all angular levels, or one for each.
struct Parameters {
  // What a scan may say.
  double min_range_m = 0.4;
  double max_range_m = 100.0;
  double voxel_size_m = 0.1;
  std::vector<double> angular_levels_deg = {0.0};
  double ring_spacing_deg = 0.0;
  double azimuth_step_deg = 0.0;

  // Evidence, eq. (2), (3).
  std::string evidence_goes_to = "every_voxel";
  bool surface_in_voxel = true;
  bool hit_is_support = true;
  std::vector<double> support_threshold_m_r = {0.15};
  std::vector<double> conflict_base_m_r = {0.2};
  std::vector<double> conflict_scale_r = {0.01};

  // Recursion, eq. (4) to (8).
  std::string conflict_strength = "linear";
  std::vector<double> conflict_sigma_m_r = {0.5};
  std::vector<double> support_rate_r = {0.8};
  std::vector<double> conflict_rate_r = {1.2};
  double support_rate_when_dynamic = 0.1;
  double increment_clip = 1.5;
  double log_odds_min = -4.0;
  double log_odds_max = 4.0;
  double forgetting = 0.002;
  double settle_time_s = 60.0;

  // Decision, eq. (9).
  double p_static_min = 0.7;
  double p_dynamic_max = 0.3;
  bool calibrate_p_static = true;

  // Replay of earlier scans for new voxels.
  int history_recent = 10;
  int history_spread = 10;
  int replay_support_min_age = 3;

  // An odometry that shakes.
  bool align_scans = true;

  // Porous things, sway and pose noise.
  double conflict_beside_surface = 0.15;
  double conflict_porous = 0.2;
  double conflict_reach_voxels = 1.2;
  bool full_support_on_return = true;

  // Loop closures.
  double submap_length_m = 0.0;

  // Objects and surfaces.
  bool resolve_objects = true;
  bool follow_objects = true;
  bool vanish_test = true;
  double speck_size_m = 0.3;
  bool lean_together = true;
  bool spare_porous = true;
  bool remember_arrivals = true;
  bool take_feet_along = true;
  bool take_insides_along = true;
  bool doubt_beside_movers = true;
  bool settle_objects_together = true;
  int hits_to_overrule = 5;

  // The experiment's structure gates (section 2.1); 0 switches a gate off.
  int gate_voxel_support = 0;
  int gate_neighbourhood_support = 0;
  int gate_grid_support = 0;
  double gate_height_above_ground_m = 0.0;

  // The rolling map.
  double rolling_radius_m = 0.0;
  std::string rolling_directory;
  int rolling_disk_mb = 10000;

  int threads = 1;
};

/// Calls visit(ParameterInfo, value) for each parameter, in reading order. `value` is a reference to double,
/// int, bool, std::string or std::vector<double>; YAML, the ROS parameter server, the reference table and the
/// tests walk this list.
template <class ParametersT, class Visitor>
void visit_parameters(ParametersT& p, Visitor&& visit);

/// The named preset: "default", or "paper" (the literal reading of the paper). Throws std::invalid_argument.
Parameters preset(const std::string& name);

/// One line for each value out of its range or option list, naming it, what was seen and what is allowed.
std::vector<std::string> problems(const Parameters& parameters);

}  // namespace stillmap

#include "stillmap/parameter_list.hpp"
