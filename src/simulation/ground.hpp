#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "simulation/shape.hpp"

namespace stillmap::simulation {

/// A rectangle of the ground, e.g. a sidewalk, at a height above the ground's own.
struct GroundPatch {
  Eigen::Vector2d min, max;  ///< corners, metres
  double height_m;
  Surface surface;
};

/// A gentle wave in the ground.
struct GroundWave {
  Eigen::Vector2d wave_vector;  ///< rad/m
  double amplitude_m;
  double phase_rad;
};

struct GroundCrossing {
  Crossing crossing;
  Surface surface;
};

/// A sloped, slightly wavy height field, covered by patches. Where patches overlap the higher one is seen;
/// at the same height, the later one.
class Ground {
 public:
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< rise per metre along x and y
  std::vector<GroundWave> waves;
  std::vector<GroundPatch> patches;

  double height_m(double x, double y) const;       ///< of the highest patch there; bare ground where none is
  double bare_height_m(double x, double y) const;  ///< without patches
  std::optional<GroundCrossing> cross(const Ray& ray, double max_range_m) const;

 private:
  std::optional<double> cross_patch(const Ray& ray, const GroundPatch& patch, double max_range_m) const;
  double steepest_slope() const;  ///< an upper bound
};

}  // namespace stillmap::simulation
