#pragma once

#include <vector>

#include "evaluation/injected_target.hpp"

namespace stillmap {

/// What paths are chosen by: a recorded scene, and where its sensor was.
struct RecordedScene {
  std::vector<Eigen::Vector3d> points;         ///< map frame, from some of the scans
  std::vector<Eigen::Vector3d> sensor_places;  ///< of every scan
  std::vector<double> times_s;                 ///< of every scan, from the first
};

/// A path near the sensor's with as little as possible of what stands there in it and before it, and clear of
/// `taken`. The same for the same scene and random numbers. Throws std::runtime_error where there is no
/// ground to walk on.
TargetPath choose_path(const RecordedScene& scene, const Eigen::Vector3d& size_m, double speed_mps,
                       const std::vector<TargetPath>& taken, simulation::Random& random);

}  // namespace stillmap
