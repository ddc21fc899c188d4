// A node to which nothing comes says so, and names what there is.

#include <gtest/gtest.h>
#include <ros/init.h>

#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

TEST(Silence, IsNamedWithWhatThereIs) {
  NodeHarness harness;  // publishes /cloud_registered and /Odometry; the node listens to /odom
  ASSERT_TRUE(harness.wait_for_connections());
  EXPECT_TRUE(harness.said("/cloud_registered: nothing has come for ", 30));
  EXPECT_TRUE(
      harness.said("it has a publisher, which is silent; there is no other sensor_msgs/PointCloud2", 1));
  EXPECT_TRUE(harness.said("/odom: nothing has come for ", 30));
  EXPECT_TRUE(harness.said("nobody publishes it; nav_msgs/Odometry are on /Odometry; set odom_topic", 1));
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "silence_test");
  return RUN_ALL_TESTS();
}
