#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "simulation/ground.hpp"
#include "simulation/world.hpp"

namespace stillmap::simulation {

/// Speed over time: straight lines between the knots, the first and the last speed before and after them.
class SpeedProfile {
 public:
  struct Knot {
    double time_s;
    double speed_mps;
  };
  explicit SpeedProfile(std::vector<Knot> knots);

  static SpeedProfile constant(double speed_mps);
  /// Stands until start_s, then takes a second to reach its speed.
  static SpeedProfile starting(double start_s, double speed_mps);
  /// Walks until stop_s and stays.
  static SpeedProfile stopping(double stop_s, double speed_mps);
  /// Goes and stands in turn, from time 0 until the end of the world.
  static SpeedProfile stop_and_go(double go_s, double stand_s, double speed_mps, double first_go_s);

  double distance_m(double time_s) const;  ///< travelled since time 0; negative before it
  double first_move_s() const;             ///< kNever_s if it always stands

 private:
  double integral_to(double time_s) const;  ///< from the first knot
  std::vector<Knot> knots_;
};

/// A way on the ground through points.
class Path {
 public:
  explicit Path(std::vector<Eigen::Vector2d> points);

  double length_m() const { return at_m_.back(); }
  /// Clamped to the ends.
  Eigen::Vector2d position(double distance_m) const;
  /// Direction of travel in radians, blended over `blend_m` around corners.
  double heading_rad(double distance_m, double blend_m) const;

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> at_m_;  ///< distance of each point from the first
};

/// Moves a body over the ground along a path that starts, at time 0, `offset_m` after its first point.
/// `wheelbase_m` = distance between its feet or axles, which the ground tilts it by; 0 = always upright.
std::function<MoverPose(double)> along(const Path& path, const SpeedProfile& profile, const Ground& ground,
                                       double offset_m = 0, double wheelbase_m = 0);

/// A body pose on the ground.
Eigen::Isometry3d on_ground(const Ground& ground, const Eigen::Vector2d& position, double heading_rad,
                            double wheelbase_m = 0);

}  // namespace stillmap::simulation
