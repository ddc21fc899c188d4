#include "stillmap/explanation.hpp"

#include <cstdio>

namespace stillmap {
namespace {

template <class... Values>
std::string printed(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

std::string of_voxel(const Explanation& e) {
  const std::string where =
      printed("(%.2f, %.2f, %.2f): ", e.asked_map_m.x(), e.asked_map_m.y(), e.asked_map_m.z());
  if (!e.in_map) return where + "no return ever came from there, so the map has nothing to judge.";
  return where + to_string(e.label) +
         printed(", p_static %.2f (log-odds %+.2f). ", static_cast<double>(e.p_static),
                 static_cast<double>(e.log_odds)) +
         printed("%d scans returned from it, %d saw through it", e.hits, e.seen_through) +
         (e.came_back ? ", and it was hit again after that, as leaves and fences are." : ".");
}

std::string what_it_means(const PlaceEvidence& evidence) {
  const double range_m = evidence.range_m, d_m = evidence.difference_m();
  const double measured_m = range_m + d_m, tau_m = evidence.conflict_above_m;
  const std::string depth =
      printed("it measured %.2f m where the place lies at %.2f m, d = %+.2f m", measured_m, range_m, d_m);
  if (evidence.kind == Evidence::kConflict)
    return depth + printed(" > tau = %.2f m: it saw through the place.", tau_m);
  if (evidence.kind == Evidence::kSupport) return depth + ": something stood there.";
  return depth + ": something nearer hid the place, which says nothing.";
}

std::string of_last_evidence(const Explanation& e) {
  const PlaceEvidence* last = last_evidence(e);
  if (last == nullptr) return "None of the kept scans says anything about it.";
  const double age_s = static_cast<double>(e.newest_stamp_ns - last->stamp_ns) * 1e-9;
  const std::string level = last->level_deg > 0 ? printed("level of %g degrees", last->level_deg)
                                                : std::string("level of the sensor's own beams");
  return std::string("Last evidence: ") + to_string(last->kind) +
         printed(", scan of %.3f s (%.1f s before the newest), ", static_cast<double>(last->stamp_ns) * 1e-9,
                 age_s) +
         level + ": " + what_it_means(*last);
}

std::string of_all_evidence(const Explanation& e) {
  int counts[4] = {};
  for (const PlaceEvidence& evidence : e.evidence) ++counts[static_cast<int>(evidence.kind)];
  return printed("The kept scans: %d conflict, %d support, %d occlusion, %d unknown.",
                 counts[static_cast<int>(Evidence::kConflict)], counts[static_cast<int>(Evidence::kSupport)],
                 counts[static_cast<int>(Evidence::kOcclusion)],
                 counts[static_cast<int>(Evidence::kUnknown)]);
}

}  // namespace

const PlaceEvidence* last_evidence(const Explanation& explanation) {
  for (const PlaceEvidence& evidence : explanation.evidence)
    if (evidence.kind != Evidence::kUnknown) return &evidence;
  return nullptr;
}

const char* to_string(Evidence evidence) {
  switch (evidence) {
    case Evidence::kUnknown:
      return "unknown";
    case Evidence::kOcclusion:
      return "occlusion";
    case Evidence::kSupport:
      return "support";
    case Evidence::kConflict:
      return "conflict";
  }
  return "";
}

std::string in_words(const Explanation& explanation) {
  return of_voxel(explanation) + " " + of_last_evidence(explanation) + " " + of_all_evidence(explanation);
}

}  // namespace stillmap
