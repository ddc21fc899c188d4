#pragma once

#include "baselines/removal_method.hpp"
#include "small_world.hpp"

namespace stillmap {

/// Feeds the frames; then tells how much of what lies inside a box was removed, over all frames.
class RemovalCheck {
 public:
  RemovalCheck(RemovalMethod& method, const std::vector<Frame>& frames) : method_(method), frames_(frames) {
    for (const Frame& frame : frames_) method_.add(frame);
    method_.finish();
  }

  /// 0 to 1; -1 where there is no point.
  double removed_share(const Eigen::Vector3d& lowest, const Eigen::Vector3d& highest) const {
    double points = 0, removed = 0;
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      const PointVerdicts verdicts = method_.map_verdicts(k, frames_[k]);
      for (std::size_t row = 0; row < verdicts.label.size(); ++row) {
        if (!is_inside(frames_[k], row, lowest, highest)) continue;
        ++points;
        removed += verdicts.label[row] == Label::kDynamic;
      }
    }
    return points > 0 ? removed / points : -1;
  }

 private:
  RemovalMethod& method_;
  const std::vector<Frame>& frames_;
};

}  // namespace stillmap
