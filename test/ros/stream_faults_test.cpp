// Faults of the stream: the node says what is wrong, answers what can be answered, and keeps its map.

#include <gtest/gtest.h>
#include <ros/init.h>

#include "ros/child_process.hpp"
#include "ros/node_harness.hpp"
#include "ros/running_node.hpp"

namespace stillmap {
namespace {

class StreamFaults : public testing::Test {
 protected:
  static void SetUpTestSuite() { harness = new NodeHarness; }
  static void TearDownTestSuite() { delete harness; }
  void SetUp() override {
    ASSERT_TRUE(harness->wait_for_connections());
    if (k == 0) learn_the_room();
    k += 100;  // a gap of ten seconds: nothing of the test before answers for this one
    for (int i = 0; i < 5; ++i) expect_good_scan();
    harness->forget_what_was_said();
  }
  // Whatever happened, the room is known to stand and the next scans are answered.
  void TearDown() override {
    k += 100;
    for (int i = 0; i < 3; ++i) expect_good_scan();
  }

  static void learn_the_room() {
    for (k = 1; k <= 30; ++k) {
      harness->publish(room_odometry(k));
      harness->publish(*room_cloud(k));
      ASSERT_NE(harness->answer(room_stamp(k)), nullptr);
    }
  }
  static nav_msgs::Odometry pose_at(int scan, double x_m) {
    nav_msgs::Odometry odometry = room_odometry(scan);
    odometry.pose.pose.position.x = x_m;
    return odometry;
  }
  void expect_good_scan() {
    ++k;
    harness->publish(room_odometry(k));
    harness->publish(*room_cloud(k));
    expect_answer(k);
  }
  void expect_answer(int scan) {
    const Answer* answer = harness->answer(room_stamp(scan));
    ASSERT_NE(answer, nullptr) << "scan " << scan;
    EXPECT_GT(answer->status->static_points, 5000u) << "of the room's 5760";
    EXPECT_LT(answer->status->dynamic_points, 60u);
  }
  std::uint64_t dropped(const std::string& reason) {
    for (int i = 0; i < 2; ++i) expect_good_scan();  // a status has what was counted before its scan
    const Status& status = *harness->answer(room_stamp(k))->status;
    for (std::size_t i = 0; i < status.drop_reasons.size(); ++i)
      if (status.drop_reasons[i] == reason) return status.dropped[i];
    return 0;
  }

  static NodeHarness* harness;
  static int k;
};
NodeHarness* StreamFaults::harness = nullptr;
int StreamFaults::k = 0;

TEST_F(StreamFaults, LostScansLeaveNoTrace) {
  for (int lost : {1, 7, 2, 40}) {
    k += lost;
    expect_good_scan();
  }
}

TEST_F(StreamFaults, ADoubledAndALateScanAreDroppedAndTold) {
  const std::uint64_t before = dropped("late");
  harness->publish(*room_cloud(k));
  harness->publish(*room_cloud(k - 1));
  EXPECT_TRUE(harness->said(
      "a scan is dropped: its stamp is not after the one before; the publisher must give each scan its own"));
  EXPECT_EQ(dropped("late"), before + 2);
}

TEST_F(StreamFaults, ScansOutOfOrderAreAnsweredInOrder) {
  for (int scan : {k + 3, k + 1, k + 2}) harness->publish(*room_cloud(scan));
  harness->wait_until([] { return false; }, 0.2);
  for (int scan : {k + 1, k + 2, k + 3}) harness->publish(room_odometry(scan));
  const std::uint64_t scans = harness->answer(room_stamp(k))->status->scans;
  for (std::uint64_t i = 1; i <= 3; ++i) {
    expect_answer(k + static_cast<int>(i));
    EXPECT_EQ(harness->answer(room_stamp(k + static_cast<int>(i)))->status->scans, scans + i);
  }
  k += 3;
}

TEST_F(StreamFaults, OdometryThatStopsIsTold) {
  const std::uint64_t before = dropped("no_pose");
  for (int i = 1; i <= 15; ++i) harness->publish(*room_cloud(k + i));
  EXPECT_TRUE(harness->said("scans wait for their pose: the newest odometry is"));
  k += 15;
  harness->publish(
      room_odometry(k));  // it goes on: the last one has its pose, the others have a gap around them
  expect_answer(k);
  EXPECT_EQ(dropped("no_pose"), before + 14);
}

TEST_F(StreamFaults, OdometryOfOneHertzIsNotInterpolated) {
  harness->wait_until([] { return false; }, 5.5);  // the same warning comes every five seconds at most
  const std::uint64_t before = dropped("no_pose");
  const int first = k;
  for (int i = 1; i <= 20; ++i) {
    harness->publish(*room_cloud(first + i));
    if (i % 10 == 0) {
      harness->publish(room_odometry(first + i));
      expect_answer(first + i);
    }
  }
  k = first + 20;
  EXPECT_TRUE(harness->said("the odometry has a gap of 1.0"));
  EXPECT_EQ(dropped("no_pose"), before + 18);
}

TEST_F(StreamFaults, OdometryThatJumpsTenMetresAndBackLeavesTheRoom) {
  harness->publish(pose_at(++k, 10));
  harness->publish(*room_cloud(k));
  EXPECT_NE(harness->answer(room_stamp(k)), nullptr);
}

TEST_F(StreamFaults, OdometryFarBeyondTheMapIsRefused) {
  harness->publish(pose_at(++k, 1e30));
  harness->publish(*room_cloud(k));
  EXPECT_TRUE(harness->said("m is farther from the origin than the"));
}

TEST_F(StreamFaults, ASubscriberThatDoesNotReadCostsNothing) {
  const int node = process_of("/stillmap");
  ASSERT_GT(node, 0);
  const ChildProcess reader({"rostopic", "echo", "--noarr", "/stillmap/labelled_points"});
  harness->wait_until([] { return false; }, 3);  // it connects
  kill(reader.pid, SIGSTOP);
  for (int i = 0; i < 50; ++i) expect_good_scan();
  const double before_mb = memory_mb(node, "VmRSS");
  for (int i = 0; i < 200; ++i) expect_good_scan();  // 200 clouds of 150 kB that nobody takes
  EXPECT_LT(memory_mb(node, "VmRSS"), before_mb + 10);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "stream_faults_test");
  return RUN_ALL_TESTS();
}
