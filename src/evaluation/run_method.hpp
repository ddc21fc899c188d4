#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/labelled_sequence.hpp"
#include "evaluation/methods.hpp"
#include "evaluation/pass_score.hpp"

namespace stillmap {

/// Of one method on one sequence.
struct MethodCost {
  double at_once_cpu_ms = 0;  ///< a scan, until it is taken in and, if so, judged at once
  double total_cpu_ms = 0;    ///< a scan, with finishing the map and the final verdicts
  std::optional<double> peak_mb;
};

/// What a picture shows of a point.
enum class PictureCode { kKept = 0, kRemovedRight = 1, kRemovedWrong = 2, kMissed = 3 };
struct PicturePoint {
  Eigen::Vector3f point;  ///< metres, from the first scan's origin, axes of the map
  PictureCode code;
};

struct MethodResult {
  std::string method;
  std::optional<PassScore>
      at_once;  ///< against labels_now; nothing from methods that judge only finished maps
  std::optional<PassScore> delayed;  ///< judged again RunOptions::delay scans later; against labels_now
  PassScore final;                   ///< against labels
  Confusion map_wise_kept, map_wise_dropped;  ///< final; uncertain kept, uncertain dropped
  MethodCost cost;
  std::string settings;
  std::vector<PicturePoint> picture;  ///< final, uncertain kept
};

/// Calls visit(name of the pass, pass) for every pass there is.
template <class Visitor>
void for_each_pass(const MethodResult& method, Visitor&& visit) {
  if (method.at_once) visit("at once", *method.at_once);
  if (method.delayed) visit("delayed", *method.delayed);
  visit("final", method.final);
}

struct RunOptions {
  bool brief = false;                   ///< neither map-wise counts nor picture, which take long
  std::size_t delay = 10;               ///< scans until the delayed verdicts; 0 = none
  double map_voxel_size_m = 0.1;        ///< of the map-wise count
  std::size_t picture_points = 70'000;  ///< at most, section 2.1
  std::uint64_t seed = 7;               ///< chooses them
};

/// `advance` is called after each scan of the two passes.
MethodResult run_method(LabelledSequence& sequence, const MethodChoice& choice, const RunOptions& options,
                        const std::function<void()>& advance);

}  // namespace stillmap
