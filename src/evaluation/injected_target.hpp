#pragma once

#include <vector>

#include "simulation/random.hpp"
#include "simulation/shape.hpp"

namespace stillmap {

/// A straight walk at constant speed over the ground.
struct TargetPath {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< map frame, on the ground
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();

  Eigen::Isometry3d T_map_target(double time_s) const;  ///< x ahead, z up
};

/// A synthetic thing that moves through a recorded scene.
struct InjectedTarget {
  std::vector<simulation::Shape> shapes;  ///< x ahead, z up, origin on the ground below the middle
  Eigen::Vector3d size_m;                 ///< of the box around them
  std::uint32_t label;                    ///< SemanticKITTI class and instance
  std::size_t points;                     ///< that a scan shows of it, if nothing hides it
  TargetPath path;

  /// Range at which a ray of the map frame meets the target; nothing when it passes.
  std::optional<double> range_m(const simulation::Ray& ray, double time_s) const;
  /// `points` places on the surface that faces the sensor, spread as its rays would be; map frame.
  std::vector<Eigen::Vector3d> seen_from(const Eigen::Vector3d& origin, double time_s,
                                         simulation::Random& random) const;
  /// `points` places all over the surface, whoever looks.
  std::vector<Eigen::Vector3d> all_over(double time_s, simulation::Random& random) const;
};

InjectedTarget make_person_target(double height_m, std::size_t points, std::uint16_t instance);
InjectedTarget make_vehicle_target(const Eigen::Vector3d& size_m, std::size_t points, std::uint16_t instance);

}  // namespace stillmap
