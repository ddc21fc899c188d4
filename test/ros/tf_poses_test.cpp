// What tf2 says of a scan's pose while transforms come from another thread.
#include "ros/tf_poses.hpp"

#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace stillmap {
namespace {

constexpr std::int64_t kPeriod_ns = 100000000;

geometry_msgs::TransformStamped transform(int scan) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp.fromNSec(static_cast<std::uint64_t>(scan * kPeriod_ns));
  transform.header.frame_id = "map";
  transform.child_frame_id = "lidar";
  transform.transform.translation.x = scan;
  transform.transform.rotation.w = 1;
  return transform;
}

PoseAnswer pose_at(const tf2::BufferCore& buffer, int scan) {
  return pose_in(buffer, "map", "lidar", scan * kPeriod_ns);
}

TEST(TfPoses, IsFoundWaitedForOrNeverToCome) {
  tf2::BufferCore buffer(ros::Duration(1000));
  EXPECT_EQ(pose_at(buffer, 5).kind, PoseAnswer::Kind::kWait) << "no such frame";
  buffer.setTransform(transform(5), "test");
  buffer.setTransform(transform(6), "test");
  EXPECT_EQ(pose_at(buffer, 5).kind, PoseAnswer::Kind::kFound);
  EXPECT_EQ(pose_at(buffer, 5).T_map_body.translation().x(), 5);
  EXPECT_EQ(pose_at(buffer, 7).kind, PoseAnswer::Kind::kWait);
  EXPECT_EQ(pose_at(buffer, 4).kind, PoseAnswer::Kind::kNever);
}

// A transform that comes while it is looked for must not look like one that cannot come any more.
TEST(TfPoses, OneThatComesMeanwhileIsFound) {
  constexpr int kScans = 300;
  tf2::BufferCore buffer(ros::Duration(1000));
  buffer.setTransform(transform(0), "test");
  std::atomic<int> asked{0};
  std::thread odometry([&] {
    for (int scan = 1; scan < kScans; ++scan) {
      while (asked < scan) std::this_thread::yield();
      buffer.setTransform(transform(scan), "test");
    }
  });
  int given_up = 0;
  for (int scan = 1; scan < kScans; ++scan) {
    asked = scan;
    PoseAnswer answer;
    while (answer.kind == PoseAnswer::Kind::kWait) answer = pose_at(buffer, scan);
    given_up += answer.kind == PoseAnswer::Kind::kNever;
  }
  odometry.join();
  EXPECT_EQ(given_up, 0);
}

}  // namespace
}  // namespace stillmap
