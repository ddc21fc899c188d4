#include "simulation/odometry.hpp"

#include <cmath>

#include "simulation/random.hpp"

namespace stillmap::simulation {
namespace {

constexpr std::uint64_t kStream = 0x0d0e7;

Eigen::Isometry3d shaken(const Eigen::Isometry3d& pose, const OdometryNoise& noise, std::size_t k) {
  Random random(noise.seed, kStream, k);
  const auto vector = [&] { return Eigen::Vector3d(random.normal(), random.normal(), random.normal()); };
  Eigen::Isometry3d result = pose;
  result.translation() += noise.noise_m * vector();
  const Eigen::Vector3d turn = noise.noise_deg * M_PI / 180.0 * vector();
  if (turn.norm() > 0) result.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  return result;
}

}  // namespace

std::vector<Eigen::Isometry3d> odometry_poses(const std::vector<Eigen::Isometry3d>& T_map_sensor_true,
                                              const OdometryNoise& noise) {
  constexpr double kYawPerPercent_deg_per_m =
      0.002;                                // what LOAM-style odometries show beside their 1 % or so
  constexpr double kTurn_rad_per_m = 0.05;  // the direction of the error changes slowly
  std::vector<Eigen::Isometry3d> poses;
  Random random(noise.seed, kStream);
  const double side = random.chance(0.5) ? 1 : -1;
  double direction_rad = random.uniform(0, 2 * M_PI);
  Eigen::Isometry3d drifted;
  for (std::size_t k = 0; k < T_map_sensor_true.size(); ++k) {
    if (k == 0) {
      drifted = T_map_sensor_true[0];
    } else {
      const Eigen::Isometry3d step = T_map_sensor_true[k - 1].inverse() * T_map_sensor_true[k];
      const double way_m = step.translation().norm();
      direction_rad += kTurn_rad_per_m * way_m;
      drifted = drifted * step;
      drifted.translate(noise.drift_percent / 100 * way_m *
                        Eigen::Vector3d(std::cos(direction_rad), std::sin(direction_rad), 0.3));
      const double yaw_deg = side * noise.drift_percent * kYawPerPercent_deg_per_m * way_m;
      drifted.rotate(Eigen::AngleAxisd(yaw_deg * M_PI / 180.0, Eigen::Vector3d::UnitZ()));
    }
    poses.push_back(shaken(drifted, noise, k));
  }
  return poses;
}

}  // namespace stillmap::simulation
