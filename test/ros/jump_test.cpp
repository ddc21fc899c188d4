// A pose graph that shifts map <- odom: the map goes along.

#include <gtest/gtest.h>
#include <ros/init.h>
#include <ros/service.h>
#include <stillmap/ExplainPoint.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

geometry_msgs::TransformStamped transform(int k, const std::string& parent, const std::string& child,
                                          double y) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = room_stamp(k);
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.y = y;
  transform.transform.rotation.w = 1;
  return transform;
}

class Jump : public testing::Test {
 protected:
  void SetUp() override {
    tf_ = nh_.advertise<tf2_msgs::TFMessage>("/tf", 100);
    ASSERT_TRUE(harness_.wait_for_connections());
    // The scans' poses and the jumps each have a listener.
    ASSERT_TRUE(harness_.wait_until([this] { return tf_.getNumSubscribers() > 0; }));
  }
  /// A scan in the room, with map <- odom at `y_m`.
  bool scan(int k, double y_m) {
    tf2_msgs::TFMessage message;
    for (const int at : {k, k + 1}) {
      message.transforms.push_back(transform(at, "map", "odom", y_m));
      message.transforms.push_back(transform(at, "odom", "lidar", 0));
    }
    tf_.publish(message);
    sensor_msgs::PointCloud2 cloud = *room_cloud(k);
    cloud.header.frame_id = "lidar";
    harness_.publish(cloud);
    return harness_.answer(room_stamp(k)) != nullptr;
  }
  static ExplainPoint::Response explain(double x, double y) {
    ExplainPoint call;
    call.request.point.x = x;
    call.request.point.y = y;
    EXPECT_TRUE(ros::service::call("/stillmap/explain_point", call));
    return call.response;
  }
  ros::NodeHandle nh_;
  ros::Publisher tf_;
  NodeHarness harness_;
};

TEST_F(Jump, TheMapGoesAlong) {
  for (int k = 0; k < 8; ++k) ASSERT_TRUE(scan(2 * k, 0));
  EXPECT_TRUE(explain(0.04, 4.99).in_map) << "the wall at 5 m";
  EXPECT_FALSE(explain(0.04, 7.99).in_map);
  for (int k = 8; k < 10; ++k) ASSERT_TRUE(scan(2 * k, 3));
  EXPECT_TRUE(
      harness_.said("odom: the map follows the corrected trajectory, 1 submaps, the farthest by 3 m"));
  const ExplainPoint::Response told = explain(0.04, 7.99);
  EXPECT_TRUE(told.in_map) << told.message;
  EXPECT_EQ(told.label, 1) << told.message;
  EXPECT_FALSE(explain(0.04, 4.99).in_map) << "it stood there before the jump";
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "jump_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
