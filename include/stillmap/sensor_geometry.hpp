#pragma once

#include <vector>

#include "stillmap/projection.hpp"

namespace stillmap {

/// What the range images must know of a sensor: how far apart its beams are.
struct SensorGeometry {
  float ring_spacing_rad = 0;  ///< between neighbouring beams in elevation
  float azimuth_step_rad = 0;  ///< between neighbouring returns of a ring; as ring_spacing_rad without rings

  bool has_rings() const { return azimuth_step_rad != ring_spacing_rad; }
};

/// One scan's answer; zeros when it holds too few returns to tell.
SensorGeometry measure_geometry(const ProjectedScan& scan);

/// Finds the geometry from the first scans: the median of their answers, fixed after kScans of them. A value
/// that is given is kept.
class GeometryEstimator {
 public:
  explicit GeometryEstimator(SensorGeometry given) : given_(given) {}
  SensorGeometry update(const ProjectedScan& scan);

 private:
  static constexpr std::size_t kScans = 10;
  SensorGeometry given_;
  std::vector<float> ring_spacings_, azimuth_steps_;
};

}  // namespace stillmap
