#include "stillmap/parameters.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace stillmap {
namespace {

std::string out_of_range(const ParameterInfo& info, double value) {
  std::ostringstream text;
  text << info.name << ": " << value << " is not in [" << info.min << ", " << info.max << "] " << info.unit;
  return text.str();
}

bool is_option(const std::string& value, const std::string& options) {
  std::istringstream stream(options);
  for (std::string option; std::getline(stream, option, '|');)
    if (option == value) return true;
  return false;
}

struct RangeCheck {
  std::vector<std::string> found;

  void number(const ParameterInfo& info, double value) {
    if (!(value >= info.min && value <= info.max)) found.push_back(out_of_range(info, value));
  }
  void operator()(const ParameterInfo&, bool) {}
  void operator()(const ParameterInfo& info, int value) { number(info, value); }
  void operator()(const ParameterInfo& info, double value) { number(info, value); }
  void operator()(const ParameterInfo& info, const std::vector<double>& values) {
    if (values.empty())
      found.push_back(std::string(info.name) + ": the list is empty; give at least one value");
    for (const double value : values) number(info, value);
  }
  void operator()(const ParameterInfo& info, const std::string& value) {
    if (*info.options != '\0' && !is_option(value, info.options))
      found.push_back(std::string(info.name) + ": '" + value + "' is not one of " + info.options);
  }
};

void check_levels(const Parameters& p, std::vector<std::string>& found) {
  const auto check = [&](const char* name, const std::vector<double>& values) {
    if (values.size() > 1 && values.size() != p.angular_levels_deg.size())
      found.push_back(std::string(name) + ": " + std::to_string(values.size()) + " values for " +
                      std::to_string(p.angular_levels_deg.size()) +
                      " angular_levels_deg; give one value for all, or one for each");
  };
  check("support_threshold_m", p.support_threshold_m_r);
  check("conflict_base_m", p.conflict_base_m_r);
  check("conflict_scale", p.conflict_scale_r);
  check("conflict_sigma_m", p.conflict_sigma_m_r);
  check("support_rate", p.support_rate_r);
  check("conflict_rate", p.conflict_rate_r);
}

}  // namespace

std::vector<std::string> problems(const Parameters& parameters) {
  RangeCheck check;
  visit_parameters(parameters, check);
  check_levels(parameters, check.found);
  if (parameters.min_range_m >= parameters.max_range_m)
    check.found.push_back("min_range_m: not below max_range_m");
  if (parameters.rolling_radius_m > 0 && parameters.rolling_radius_m < parameters.max_range_m)
    check.found.push_back("rolling_radius_m: below max_range_m; give 0 (off) or at least that");
  if (parameters.rolling_radius_m > 0 && parameters.submap_length_m > 0)
    check.found.push_back(
        "submap_length_m: does not go with rolling_radius_m, as far tiles cannot be moved; set one of them "
        "to 0");
  return check.found;
}

Parameters preset(const std::string& name) {
  Parameters p;
  if (name == "default") return p;
  if (name != "paper") throw std::invalid_argument("preset: '" + name + "' is not one of default|paper");
  // Every voxel compares its own range with I_O: read so, the preset comes to the figures of table 2; with
  // the nearest voxel of a pixel alone it removes a third as much.
  p.angular_levels_deg = {2.5, 2.0, 1.5};
  p.voxel_size_m = 0.05;  // table 1
  p.hit_is_support = false;
  p.support_rate_when_dynamic = p.support_rate_r.front();
  p.settle_time_s = 0;
  p.calibrate_p_static = false;
  p.history_recent = p.history_spread = 0;
  p.align_scans = false;
  p.conflict_beside_surface = p.conflict_porous = 1;
  p.conflict_reach_voxels = 0;
  p.full_support_on_return = false;
  p.resolve_objects = false;
  p.lean_together = p.spare_porous = p.remember_arrivals = p.take_feet_along = p.take_insides_along = false;
  p.doubt_beside_movers = p.settle_objects_together = false;
  p.hits_to_overrule = 0;
  p.gate_voxel_support = 3;  // section 2.1
  p.gate_neighbourhood_support = 60;
  p.gate_grid_support = 12;
  p.gate_height_above_ground_m = 0.6;
  return p;
}

}  // namespace stillmap
