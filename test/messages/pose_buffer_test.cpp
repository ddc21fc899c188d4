#include "messages/pose_buffer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stillmap {
namespace {

using Kind = PoseAnswer::Kind;
constexpr std::int64_t kTenth_ns = 100'000'000;
constexpr double kDegree = 3.14159265358979323846 / 180;

Eigen::Isometry3d pose(double x, double yaw_deg) {
  return Eigen::Translation3d(x, 0, 0) * Eigen::AngleAxisd(yaw_deg * kDegree, Eigen::Vector3d::UnitZ());
}

TEST(PoseBuffer, GivesTheExactPoseOfAnExactStamp) {
  PoseBuffer buffer(0.5);
  buffer.add(kTenth_ns, pose(1, 10));
  const PoseAnswer answer = buffer.at(kTenth_ns);
  EXPECT_EQ(answer.kind, Kind::kFound);
  EXPECT_TRUE(answer.T_map_body.matrix() == pose(1, 10).matrix());
}

// PCL cuts stamps, and doubles round them.
TEST(PoseBuffer, TwoMicrosecondsAreTheSameMoment) {
  PoseBuffer buffer(0.5);
  buffer.add(kTenth_ns, pose(1, 10));
  for (const std::int64_t off_ns : {-2'000, -999, 999, 2'000}) {
    const PoseAnswer answer = buffer.at(kTenth_ns + off_ns);
    EXPECT_EQ(answer.kind, Kind::kFound) << off_ns;
    EXPECT_TRUE(answer.T_map_body.matrix() == pose(1, 10).matrix()) << off_ns;
  }
  EXPECT_EQ(buffer.at(kTenth_ns + 3'000).kind, Kind::kWait);
}

TEST(PoseBuffer, InterpolatesBetweenNeighboursWhateverTheirOrder) {
  PoseBuffer buffer(0.5);
  buffer.add(2 * kTenth_ns, pose(3, 30));
  buffer.add(kTenth_ns, pose(1, 10));
  const PoseAnswer answer = buffer.at(kTenth_ns + kTenth_ns / 4);
  EXPECT_EQ(answer.kind, Kind::kFound);
  EXPECT_TRUE(answer.T_map_body.isApprox(pose(1.5, 15), 1e-9));
}

TEST(PoseBuffer, TurnsTheShortWay) {
  PoseBuffer buffer(0.5);
  buffer.add(0, pose(0, 170));
  buffer.add(kTenth_ns, pose(0, 190));
  EXPECT_TRUE(buffer.at(kTenth_ns / 2).T_map_body.isApprox(pose(0, 180), 1e-9));
}

TEST(PoseBuffer, WaitsForThePoseAfterTheStamp) {
  PoseBuffer buffer(0.5);
  EXPECT_EQ(buffer.at(kTenth_ns).kind, Kind::kWait);
  EXPECT_EQ(buffer.at(kTenth_ns).why, "no odometry has come yet");
  buffer.add(0, pose(0, 0));
  EXPECT_EQ(buffer.at(kTenth_ns).kind, Kind::kWait);
  EXPECT_NE(buffer.at(kTenth_ns).why.find("0.100000 s older"), std::string::npos);
}

TEST(PoseBuffer, NeverExtrapolatesAndNeverBridgesAGap) {
  PoseBuffer buffer(0.5);
  buffer.add(kTenth_ns, pose(0, 0));
  EXPECT_EQ(buffer.at(0).kind, Kind::kNever);
  buffer.add(10 * kTenth_ns, pose(1, 0));
  EXPECT_EQ(buffer.at(5 * kTenth_ns).kind, Kind::kNever);
  EXPECT_NE(buffer.at(5 * kTenth_ns).why.find("gap of 0.900000 s"), std::string::npos);
}

TEST(PoseBuffer, ForgetsTheOldestBeyondItsCapacity) {
  PoseBuffer buffer(0.5, 2);
  for (int i = 0; i < 3; ++i) buffer.add(i * kTenth_ns, pose(i, 0));
  EXPECT_EQ(buffer.at(0).kind, Kind::kNever);
  EXPECT_EQ(buffer.at(kTenth_ns).kind, Kind::kFound);
}

}  // namespace
}  // namespace stillmap
