// rosbag play through the launch file. A loaded machine may drop scans, so this asserts that most are
// answered and that the map is saved when the recording ends; flow_test compares labels.

#include <gtest/gtest.h>
#include <ros/init.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <filesystem>

#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

TEST(Replay, ScansAreAnsweredAndTheMapIsSaved) {
  NodeHarness harness;
  rosbag::Bag bag(STILLMAP_BAG);
  const std::size_t scans = rosbag::View(bag, rosbag::TopicQuery("/cloud_registered")).size();
  EXPECT_TRUE(harness.wait_until([&] { return harness.answers() >= scans * 8 / 10; }, 60))
      << harness.answers() << " of " << scans << " scans answered";
  const std::string map = ros::NodeHandle("/stillmap").param<std::string>("save_map", "");
  EXPECT_TRUE(harness.wait_until([&] { return std::filesystem::exists(map); }, 60)) << map;
  std::filesystem::remove(map);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "replay_test");
  return RUN_ALL_TESTS();
}
