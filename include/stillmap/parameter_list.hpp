#pragma once

// The one list of parameters; see parameters.hpp. Symbols are the paper's.

#include "stillmap/parameters.hpp"

namespace stillmap {

template <class ParametersT, class Visitor>
void visit_parameters(ParametersT& p, Visitor&& visit) {
  const auto number = [&](const char* name, const char* unit, double min, double max, auto& value,
                          const char* help) {
    visit(ParameterInfo{name, unit, min, max, "", help}, value);
  };
  const auto choice = [&](const char* name, const char* options, auto& value, const char* help) {
    visit(ParameterInfo{name, "", 0, 0, options, help}, value);
  };
  const auto text = [&](const char* name, auto& value, const char* help) {
    visit(ParameterInfo{name, "", 0, 0, "", help}, value);
  };
  const auto flag = [&](const char* name, auto& value, const char* help) {
    visit(ParameterInfo{name, "", 0, 1, "", help}, value);
  };

  number("min_range_m", "m", 0.0, 20.0, p.min_range_m, "nearer returns are the robot itself: not judged");
  number("max_range_m", "m", 1.0, 500.0, p.max_range_m, "farther returns are not judged and not mapped");
  number("voxel_size_m", "m", 0.02, 2.0, p.voxel_size_m, "edge of a voxel, the spatial element i");
  number(
      "angular_levels_deg", "deg", 0.0, 10.0, p.angular_levels_deg,
      "pixel sizes of the range images, the levels r; 0 = the sensor's own beam spacing, bracketed between "
      "neighbouring beams");
  number("ring_spacing_deg", "deg", 0.0, 10.0, p.ring_spacing_deg,
         "angle between rings; 0 = found from the scans");
  number("azimuth_step_deg", "deg", 0.0, 10.0, p.azimuth_step_deg,
         "angle between two returns of a ring; 0 = found from the scans");

  choice(
      "evidence_goes_to", "every_voxel|nearest_voxel", p.evidence_goes_to,
      "who gets a pixel's evidence: every voxel compares its own range with I_O, or only the pixel's nearest "
      "voxel, I_M");
  flag("surface_in_voxel", p.surface_in_voxel,
       "a voxel's own range is that of the mean of its returns; else of its centre");
  flag("hit_is_support", p.hit_is_support,
       "a voxel that this scan hits is supported whatever its pixel says");
  number("support_threshold_m", "m", 0.01, 5.0, p.support_threshold_m_r,
         "epsilon_r of support and occlusion");
  number("conflict_base_m", "m", 0.01, 10.0, p.conflict_base_m_r, "tau_0,r of eq. (3)");
  number("conflict_scale", "", 0.0, 1.0, p.conflict_scale_r, "alpha_r of eq. (3)");

  choice("conflict_strength", "linear|sigmoid", p.conflict_strength, "the form of g, eq. (6)");
  number("conflict_sigma_m", "m", 0.01, 20.0, p.conflict_sigma_m_r, "sigma_r of eq. (6)");
  number("support_rate", "", 0.0, 10.0, p.support_rate_r, "eta_r of eq. (5), (7)");
  number("conflict_rate", "", 0.0, 10.0, p.conflict_rate_r, "kappa_r of eq. (5); more than eta_r");
  number("support_rate_when_dynamic", "", 0.0, 10.0, p.support_rate_when_dynamic,
         "eta while L < 0: what was seen through must not creep back");
  number("increment_clip", "", 0.01, 20.0, p.increment_clip, "largest |dL| of one scan, section 1.2.2 (2)");
  number("log_odds_min", "", -15.0, -0.1, p.log_odds_min, "lower bound of L");
  number("log_odds_max", "", 0.1, 15.0, p.log_odds_max, "upper bound of L");
  number("forgetting", "", 0.0, 0.5, p.forgetting, "lambda of eq. (8), for each observation");
  number(
      "settle_time_s", "s", 0.0, 300.0, p.settle_time_s,
      "steady support that takes what moved in from log_odds_min to 0: a mover that stops stays out of the "
      "static map so long; 0 = off");

  number("p_static_min", "", 0.5, 1.0, p.p_static_min, "tau_sta of eq. (9)");
  number("p_dynamic_max", "", 0.0, 0.5, p.p_dynamic_max, "tau_dyn of eq. (9)");
  flag(
      "calibrate_p_static", p.calibrate_p_static,
      "a point's p_static says how often points like it stand; else it is p of eq. (1), which decides in any "
      "case");

  number("history_recent", "scans", 0, 100, p.history_recent, "newest scans kept to judge new voxels");
  number("history_spread", "scans", 0, 100, p.history_spread, "older scans kept, chosen by place");
  number("replay_support_min_age", "scans", 1, 100, p.replay_support_min_age,
         "support for a new voxel counts only from scans at least this old");

  flag("align_scans", p.align_scans,
       "a scan whose pose jumps against surface known to stand is moved onto it before it is judged");

  number("conflict_beside_surface", "", 0.0, 1.0, p.conflict_beside_surface,
         "factor on a conflict where this scan hits, right beside, surface known to stand: leaves, edges, "
         "pose noise");
  number("conflict_porous", "", 0.0, 1.0, p.conflict_porous,
         "factor on a conflict with surface that was hit again after it was seen through, or beside such");
  number(
      "conflict_reach_voxels", "voxel edges", 0.0, 100.0, p.conflict_reach_voxels,
      "a beam speaks in full against surface this near; wider gaps between beams weaken a conflict: what is "
      "thin slips through them; 0 = off");
  flag("full_support_on_return", p.full_support_on_return,
       "a voxel hit again after it was seen through gets the full support_rate: porous things do that, "
       "movers do not");

  number(
      "submap_length_m", "m", 0.0, 1000.0, p.submap_length_m,
      "the map can follow a corrected trajectory, in pieces that each were first seen on so much of the way; "
      "0 = off");

  flag("resolve_objects", p.resolve_objects,
       "an object with a clear majority, or a known surface, decides its undecided points");
  flag("follow_objects", p.follow_objects,
       "an object where something moved in the last scans goes on moving");
  flag("vanish_test", p.vanish_test,
       "new surface right behind surface that vanished is the thing that moved there");
  number("speck_size_m", "m", 0.0, 2.0, p.speck_size_m,
         "moving pieces smaller than this on an object that stands are deferred; 0 = off");
  flag("lean_together", p.lean_together,
       "an object of which at least half leans towards moving moves, though hardly a point of it is decided");
  flag("spare_porous", p.spare_porous,
       "of leaves and the like, hit and seen through in turn, the undecided move only with half of those "
       "around, and in the end only what is hardly in doubt");
  flag("remember_arrivals", p.remember_arrivals,
       "the new voxels of a thing that moves as a whole count as seen through: it may stop right there");
  flag("take_feet_along", p.take_feet_along,
       "what rises a little above the ground right below something that moves goes with it");
  flag("take_insides_along", p.take_insides_along,
       "what is seen for the first time through the windows of a moving vehicle goes with it");
  flag(
      "doubt_beside_movers", p.doubt_beside_movers,
      "surface in or right beside which a mover was seen has to be seen again to be known to stand: where it "
      "stood before, it leaves no ghost");
  flag("settle_objects_together", p.settle_objects_together,
       "in the end, an object of which nearly all that is decided moved has moved as a whole");
  number("hits_to_overrule", "scans", 0, 255, p.hits_to_overrule,
         "in the end, what was dynamic at the scan's own time turns static only where so many scans hit the "
         "voxel");

  number("gate_voxel_support", "scans", 0, 1000, p.gate_voxel_support,
         "a dynamic verdict stands only on a voxel hit in fewer scans (section 2.1); 0 = off");
  number("gate_neighbourhood_support", "points", 0, 100000, p.gate_neighbourhood_support,
         "or where its 3x3x3 neighbourhood holds fewer points; 0 = off");
  number("gate_grid_support", "points", 0, 100000, p.gate_grid_support,
         "and its vertical grid column holds fewer points; 0 = off");
  number("gate_height_above_ground_m", "m", 0.0, 10.0, p.gate_height_above_ground_m,
         "and it lies higher above the local ground; 0 = off");

  number("rolling_radius_m", "m", 0.0, 100000.0, p.rolling_radius_m,
         "the map within it, seen from above, stays in memory; 0 = all of it, else at least max_range_m");
  text("rolling_directory", p.rolling_directory,
       "folder for what lies farther, which is read back on return; empty = it is forgotten");
  number("rolling_disk_mb", "MB", 1, 500000, p.rolling_disk_mb,
         "size of that folder; beyond, what was written longest ago is removed");

  number("threads", "", 1, 64, p.threads, "worker threads; the labels do not depend on it");
}

}  // namespace stillmap
