// A node whose clock stands and whose tf2 does not know the clouds' frame says so, with what mends it.

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/init.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

TEST(DoctorSpeaks, OfAClockThatStandsAndFramesThatAreUnknown) {
  NodeHarness harness;
  std::map<std::string, std::string> diagnosed;
  const boost::function<void(const diagnostic_msgs::DiagnosticArrayConstPtr&)> keep =
      [&](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
        for (const diagnostic_msgs::DiagnosticStatus& status : array->status)
          if (status.name == "stillmap: setup")
            for (const diagnostic_msgs::KeyValue& value : status.values) diagnosed[value.key] = value.value;
      };
  ros::NodeHandle nh;
  const ros::Subscriber subscriber = nh.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10, keep);
  ros::Publisher transforms = nh.advertise<tf2_msgs::TFMessage>("/tf", 10);
  ASSERT_TRUE(harness.wait_for_connections());
  ASSERT_TRUE(harness.wait_until([&] { return transforms.getNumSubscribers() > 0; }));

  geometry_msgs::TransformStamped transform;
  transform.header.stamp = room_stamp(0);
  transform.header.frame_id = "odom";
  transform.child_frame_id = "base_link";
  transform.transform.rotation.w = 1;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  transforms.publish(message);
  for (int k = 0; k < 12; ++k) {
    sensor_msgs::PointCloud2Ptr cloud = room_cloud(k);
    cloud->header.frame_id = "/lidar";
    harness.publish(*cloud);
  }
  EXPECT_TRUE(
      harness.said("doctor: clock: use_sim_time is true, but nobody sends /clock: play the recording with "
                   "--clock, or `rosparam set use_sim_time false`"));
  EXPECT_TRUE(harness.said("doctor: tf: tf2 does not know the frame lidar (it knows "));
  EXPECT_TRUE(harness.said("set fixed_frame and body_frame to frames that it knows", 1));
  EXPECT_TRUE(harness.wait_until([&] { return diagnosed.count("clock") && diagnosed.count("tf"); }));
  EXPECT_NE(diagnosed["tf"].find("base_link"), std::string::npos) << diagnosed["tf"];
  EXPECT_EQ(diagnosed["tf"].find("the frame odom"), std::string::npos) << diagnosed["tf"];
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "doctor_speaks_test");
  return RUN_ALL_TESTS();
}
