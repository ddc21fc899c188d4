// The poses that a simulated odometry gives.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/odometry.hpp"
#include "simulation/shape.hpp"

namespace stillmap::simulation {
namespace {

std::vector<Eigen::Isometry3d> straight(std::size_t count, double step_m) {
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t k = 0; k < count; ++k) poses.push_back(pose_at(static_cast<double>(k) * step_m, 0, 1));
  return poses;
}

TEST(Odometry, WithoutNoiseItIsTheTruth) {
  const auto poses = straight(20, 1);
  const auto odometry = odometry_poses(poses, {});
  for (std::size_t k = 0; k < poses.size(); ++k) {
    EXPECT_TRUE(odometry[k].matrix().isApprox(poses[k].matrix(), 1e-12));
  }
}

TEST(Odometry, NoiseHasTheSigmasAskedFor) {
  const auto poses = straight(2000, 0);
  const auto odometry = odometry_poses(poses, {1, 0.05, 0.2, 0});
  double squares_m2 = 0, squares_deg2 = 0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Eigen::Isometry3d error = poses[k].inverse() * odometry[k];
    squares_m2 += error.translation().squaredNorm() / 3;
    const double angle_deg = Eigen::AngleAxisd(error.linear()).angle() * 180 / M_PI;
    squares_deg2 += angle_deg * angle_deg / 3;
  }
  EXPECT_NEAR(std::sqrt(squares_m2 / 2000), 0.05, 0.003);
  EXPECT_NEAR(std::sqrt(squares_deg2 / 2000), 0.2, 0.01);
}

TEST(Odometry, DriftGrowsWithTheWayAndNotWithTime) {
  const OdometryNoise one_percent{1, 0, 0, 1};
  const auto moving = odometry_poses(straight(11, 1), one_percent);
  const double error_m = (moving[10].translation() - straight(11, 1)[10].translation()).norm();
  EXPECT_GT(error_m, 0.07);
  EXPECT_LT(error_m, 0.13);
  const auto standing = odometry_poses(straight(11, 0), one_percent);
  EXPECT_LT((standing[10].translation() - standing[0].translation()).norm(), 1e-12);
}

}  // namespace
}  // namespace stillmap::simulation
