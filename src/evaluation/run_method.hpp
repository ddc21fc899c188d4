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
      at_once;      ///< against labels_now; nothing from methods that judge only finished maps
  PassScore final;  ///< against labels
  Confusion map_wise_kept, map_wise_dropped;  ///< final; uncertain kept, uncertain dropped
  MethodCost cost;
  std::string settings;
  std::vector<PicturePoint> picture;  ///< final, uncertain kept
};

struct RunOptions {
  double map_voxel_size_m = 0.1;        ///< of the map-wise count
  std::size_t picture_points = 70'000;  ///< at most, section 2.1
  std::uint64_t seed = 7;               ///< chooses them
};

/// `advance` is called after each scan of the two passes.
MethodResult run_method(LabelledSequence& sequence, const MethodChoice& choice, const RunOptions& options,
                        const std::function<void()>& advance);

}  // namespace stillmap
