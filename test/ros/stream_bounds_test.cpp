// What the parameters say of the stream: after_jump_back: new_map, and max_cloud_mb.

#include <gtest/gtest.h>
#include <ros/init.h>

#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

class StreamBounds : public testing::Test {
 protected:
  static void SetUpTestSuite() { harness = new NodeHarness; }
  static void TearDownTestSuite() { delete harness; }
  void SetUp() override { ASSERT_TRUE(harness->wait_for_connections()); }

  static std::uint64_t scans_after(int k) {
    harness->publish(room_odometry(k));
    harness->publish(*room_cloud(k));
    const Answer* answer = harness->answer(room_stamp(k));
    EXPECT_NE(answer, nullptr) << "scan " << k;
    return answer == nullptr ? 0 : answer->status->scans;
  }
  static NodeHarness* harness;
};
NodeHarness* StreamBounds::harness = nullptr;

TEST_F(StreamBounds, ARecordingThatLoopsBeginsANewMap) {
  for (int lap = 0; lap < 3; ++lap)
    for (int k = 1; k <= 15; ++k)
      EXPECT_EQ(scans_after(k - 100 * lap), static_cast<std::uint64_t>(k)) << "lap " << lap;
  EXPECT_TRUE(harness->said("/cloud_registered: the stamps jumped back by"));
  EXPECT_TRUE(harness->said("; the map begins anew"));
}

TEST_F(StreamBounds, ACloudBeyondItsSizeIsDroppedAndTold) {
  const std::uint64_t before = scans_after(100);
  sensor_msgs::PointCloud2 large = *room_cloud(101);
  large.data.resize(200'001);
  harness->publish(room_odometry(101));
  harness->publish(large);
  EXPECT_TRUE(harness->said("a scan is dropped: it has 200001 bytes; it is more than max_cloud_mb"));
  EXPECT_EQ(scans_after(102), before + 1);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "stream_bounds_test");
  return RUN_ALL_TESTS();
}
