// A manager that loads and unloads the nodelet a hundred times: it answers every time, and memory does not
// grow.

#include <gtest/gtest.h>
#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>
#include <ros/init.h>
#include <ros/service.h>

#include "ros/child_process.hpp"
#include "ros/node_harness.hpp"
#include "ros/running_node.hpp"

namespace stillmap {
namespace {

constexpr int kTimes = 100, kWarmUp = 30;
constexpr double kMostGrowth_mb = 8;  // a single map of the room has more

bool load() {
  nodelet::NodeletLoad call;
  call.request.type = "stillmap/StillmapNodelet";
  call.request.name = "/stillmap";
  return ros::service::call("/manager/load_nodelet", call) && call.response.success;
}

bool unload() {
  nodelet::NodeletUnload call;
  call.request.name = "/stillmap";
  return ros::service::call("/manager/unload_nodelet", call) && call.response.success;
}

TEST(Reload, AHundredTimesWithoutALeak) {
  ros::NodeHandle nh;  // before there is one, roscpp 1.14 knows no time to wait
  ASSERT_TRUE(ros::service::waitForService("/manager/load_nodelet", ros::Duration(30)));
  const int manager = process_of("/manager");
  ASSERT_GT(manager, 0);
  ros::Publisher clouds = nh.advertise<sensor_msgs::PointCloud2>("/cloud_registered", 100);
  ros::Publisher odometry = nh.advertise<nav_msgs::Odometry>("/Odometry", 100);
  std::uint64_t scans = 0;
  const boost::function<void(const StatusConstPtr&)> keep = [&](const StatusConstPtr& status) {
    scans = status->scans;
  };
  double warm_mb = 0;
  for (int i = 0; i < kTimes; ++i) {
    ASSERT_TRUE(load()) << "time " << i;
    scans = 0;
    const ros::Subscriber subscriber = nh.subscribe<Status>("/stillmap/status", 10, keep);
    ASSERT_TRUE(NodeHarness::wait_until([&] {
      return clouds.getNumSubscribers() == 1 && odometry.getNumSubscribers() == 1 &&
             subscriber.getNumPublishers() == 1;
    })) << "time "
        << i;
    for (int k = 0; k < 3; ++k) {
      odometry.publish(room_odometry(10 * i + k));
      clouds.publish(room_cloud(10 * i + k));
    }
    EXPECT_TRUE(NodeHarness::wait_until([&] { return scans == 3; })) << "time " << i << ": " << scans;
    ASSERT_TRUE(unload()) << "time " << i;
    if (i == kWarmUp) warm_mb = memory_mb(manager, "VmRSS");
  }
  const double grown_mb = memory_mb(manager, "VmRSS") - warm_mb;
  std::printf("memory of the manager: %.1f MB after %d times, %+.1f MB after %d\n", warm_mb, kWarmUp,
              grown_mb, kTimes);
  EXPECT_LT(grown_mb, kMostGrowth_mb);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "reload_test");
  return RUN_ALL_TESTS();
}
