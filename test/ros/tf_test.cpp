// Scans and tf2 alone.

#include <gtest/gtest.h>
#include <ros/init.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

class Tf : public testing::Test {
 protected:
  // One publisher for all tests: one that goes and comes back may be dropped again by a node that is told of
  // both late.
  static void SetUpTestSuite() { publisher_ = ros::NodeHandle().advertise<tf2_msgs::TFMessage>("/tf", 100); }
  static void TearDownTestSuite() { publisher_.shutdown(); }
  void SetUp() override {
    ASSERT_TRUE(harness_.wait_for_connections());
    ASSERT_TRUE(harness_.wait_until([] { return publisher_.getNumSubscribers() > 0; }));
  }
  void publish_transform(int k) {
    geometry_msgs::TransformStamped transform;
    transform.header = room_odometry(k).header;
    transform.header.frame_id = "odom";
    transform.child_frame_id = "lidar";
    transform.transform.translation.x = 100;
    transform.transform.rotation.w = 1;
    tf2_msgs::TFMessage message;
    message.transforms.push_back(transform);
    publisher_.publish(message);
  }
  void publish_cloud(int k) {
    sensor_msgs::PointCloud2 cloud = *room_cloud(k);
    cloud.header.frame_id = "/lidar";
    harness_.publish(cloud);
  }
  NodeHarness harness_;
  static ros::Publisher publisher_;
};
ros::Publisher Tf::publisher_;

TEST_F(Tf, AScanWaitsForItsTransform) {
  publish_cloud(1);
  EXPECT_TRUE(harness_.said("scans wait for their pose: tf2 has no odom <- lidar"));
  publish_transform(0);
  EXPECT_EQ(harness_.answer(room_odometry(1).header.stamp, 0.5), nullptr) << "never extrapolated";
  publish_transform(2);
  const Answer* answer = harness_.answer(room_odometry(1).header.stamp);
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->labelled_points->header.frame_id, "lidar") << "without the leading slash";
}

TEST_F(Tf, AScanBeforeTheFirstTransformIsDropped) {
  publish_transform(100);
  publish_transform(101);
  publish_cloud(100);
  ASSERT_NE(harness_.answer(room_odometry(100).header.stamp), nullptr);
  publish_cloud(99 - 1000);
  EXPECT_TRUE(harness_.said("a scan is dropped: tf2 has no odom <- lidar at its stamp"));
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "tf_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
