#include "simulation/path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillmap::simulation {

SpeedProfile::SpeedProfile(std::vector<Knot> knots) : knots_(std::move(knots)) {}

SpeedProfile SpeedProfile::constant(double speed_mps) {
  return SpeedProfile({{0, speed_mps}});
}

SpeedProfile SpeedProfile::starting(double start_s, double speed_mps) {
  return SpeedProfile({{start_s, 0}, {start_s + 1, speed_mps}});
}

SpeedProfile SpeedProfile::stopping(double stop_s, double speed_mps) {
  return SpeedProfile({{stop_s - 0.5, speed_mps}, {stop_s, 0}});
}

SpeedProfile SpeedProfile::stop_and_go(double go_s, double stand_s, double speed_mps, double first_go_s) {
  constexpr double kRamp_s = 0.5;
  constexpr int kTurns = 200;
  std::vector<Knot> knots;
  double time_s = first_go_s;
  for (int turn = 0; turn < kTurns; ++turn) {
    knots.push_back({time_s, 0});
    knots.push_back({time_s + kRamp_s, speed_mps});
    knots.push_back({time_s + kRamp_s + go_s, speed_mps});
    knots.push_back({time_s + 2 * kRamp_s + go_s, 0});
    time_s += 2 * kRamp_s + go_s + stand_s;
  }
  return SpeedProfile(std::move(knots));
}

double SpeedProfile::distance_m(double time_s) const {
  return integral_to(time_s) - integral_to(0);
}

double SpeedProfile::integral_to(double time_s) const {
  double distance_m = 0;
  if (time_s <= knots_.front().time_s) return (time_s - knots_.front().time_s) * knots_.front().speed_mps;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const Knot& from = knots_[i];
    const Knot& to = knots_[i + 1];
    const double share = std::min(1.0, (time_s - from.time_s) / (to.time_s - from.time_s));
    const double speed_mps = from.speed_mps + share * (to.speed_mps - from.speed_mps);
    distance_m += share * (to.time_s - from.time_s) * (from.speed_mps + speed_mps) / 2;
    if (share < 1.0) return distance_m;
  }
  return distance_m + (time_s - knots_.back().time_s) * knots_.back().speed_mps;
}

double SpeedProfile::first_move_s() const {
  if (knots_.front().speed_mps != 0) return -kNever_s;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    if (knots_[i + 1].speed_mps != 0) return knots_[i].time_s;
  }
  return kNever_s;
}

Path::Path(std::vector<Eigen::Vector2d> points) : points_(std::move(points)), at_m_{0} {
  for (std::size_t i = 1; i < points_.size(); ++i) {
    at_m_.push_back(at_m_.back() + (points_[i] - points_[i - 1]).norm());
  }
}

Eigen::Vector2d Path::position(double distance_m) const {
  const double clamped_m = std::clamp(distance_m, 0.0, length_m());
  const auto after = std::upper_bound(at_m_.begin() + 1, at_m_.end() - 1, clamped_m) - at_m_.begin();
  const auto i = static_cast<std::size_t>(after);
  const double share = (clamped_m - at_m_[i - 1]) / (at_m_[i] - at_m_[i - 1]);
  return points_[i - 1] + share * (points_[i] - points_[i - 1]);
}

double Path::heading_rad(double distance_m, double blend_m) const {
  // Near an end the window moves inward: the heading there is that of the last stretch.
  const double middle_m = std::clamp(distance_m, blend_m, std::max(blend_m, length_m() - blend_m));
  const Eigen::Vector2d chord = position(middle_m + blend_m) - position(middle_m - blend_m);
  return std::atan2(chord.y(), chord.x());
}

Eigen::Isometry3d on_ground(const Ground& ground, const Eigen::Vector2d& position, double heading_rad,
                            double wheelbase_m) {
  const Eigen::Vector2d ahead(std::cos(heading_rad), std::sin(heading_rad));
  const Eigen::Vector2d front = position + wheelbase_m / 2 * ahead, rear = position - wheelbase_m / 2 * ahead;
  const double front_m = ground.height_m(front.x(), front.y()), rear_m = ground.height_m(rear.x(), rear.y());
  Eigen::Isometry3d T = pose_at(position.x(), position.y(), (front_m + rear_m) / 2, heading_rad);
  if (wheelbase_m > 0)
    T.rotate(Eigen::AngleAxisd(-std::atan2(front_m - rear_m, wheelbase_m), Eigen::Vector3d::UnitY()));
  return T;
}

std::function<MoverPose(double)> along(const Path& path, const SpeedProfile& profile, const Ground& ground,
                                       double offset_m, double wheelbase_m) {
  return [path, profile, ground, offset_m, wheelbase_m](double time_s) {
    const double distance_m = offset_m + profile.distance_m(time_s);
    constexpr double kStep_m = 0.4;  // a pedestrian turns within a step, a car within its length
    const double heading_rad = path.heading_rad(distance_m, std::max(kStep_m, wheelbase_m));
    return MoverPose{on_ground(ground, path.position(distance_m), heading_rad, wheelbase_m), distance_m};
  };
}

}  // namespace stillmap::simulation
