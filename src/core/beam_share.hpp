#pragma once

#include <algorithm>

#include "stillmap/sensor_geometry.hpp"

namespace stillmap {

/// How much a conflict counts where beams pass on both sides of an element rather than through it: about the
/// chance that one of them met it. Leaves, poles and rails slip between the beams of a sparse scan. The map's
/// own voxels take its square root: they are met again and again, and must clear.
class BeamShare {
 public:
  /// Surface within `reach_m` of a beam counts as met; 0: all conflicts count in full.
  BeamShare(float reach_m, SensorGeometry beams)
      : across_m_(reach_m / beams.azimuth_step_rad),
        along_m_(reach_m / beams.ring_spacing_rad),
        on_(reach_m > 0) {}

  float at(float range_m) const {
    constexpr float kLeast = 0.15F;  // several scans without a return say something even so
    if (!on_) return 1.0F;
    return std::max(kLeast, std::min(1.0F, across_m_ / range_m) * std::min(1.0F, along_m_ / range_m));
  }

 private:
  float across_m_, along_m_;  ///< range up to which the beams of a ring, and the rings, leave no gap
  bool on_;
};

}  // namespace stillmap
