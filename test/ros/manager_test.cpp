// The launch file's manager:=NAME: the same topics and parameters, in the manager's process.

#include <gtest/gtest.h>
#include <nodelet/NodeletList.h>
#include <ros/init.h>
#include <ros/service.h>

#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

TEST(Manager, RunsTheNodeletOfTheLaunchFile) {
  NodeHarness harness;
  ASSERT_TRUE(harness.wait_for_connections());
  harness.publish(room_odometry(0));
  harness.publish(*room_cloud(0));
  EXPECT_NE(harness.answer(room_stamp(0)), nullptr);
  nodelet::NodeletList list;
  ASSERT_TRUE(ros::service::call("/some_manager/list", list));
  EXPECT_EQ(list.response.nodelets, (std::vector<std::string>{"/stillmap"}));
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "manager_test");
  return RUN_ALL_TESTS();
}
