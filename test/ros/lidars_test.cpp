// Two LiDARs with their places in tf2.

#include <gtest/gtest.h>
#include <ros/init.h>
#include <ros/service.h>
#include <stillmap/ExplainPoint.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

class Lidars : public testing::Test {
 protected:
  void SetUp() override {
    rear_ = nh_.advertise<sensor_msgs::PointCloud2>("/rear", 100);
    tf_ = nh_.advertise<tf2_msgs::TFMessage>("/tf", 100);
    ASSERT_TRUE(harness_.wait_for_connections());
    ASSERT_TRUE(
        harness_.wait_until([this] { return rear_.getNumSubscribers() > 0 && tf_.getNumSubscribers() > 0; }));
  }
  void publish_transform(int k, const std::string& frame, double x) {
    tf2_msgs::TFMessage message;
    message.transforms.resize(1);
    message.transforms[0].header.stamp = room_stamp(k);
    message.transforms[0].header.frame_id = "odom";
    message.transforms[0].child_frame_id = frame;
    message.transforms[0].transform.translation.x = x;
    message.transforms[0].transform.rotation.w = 1;
    tf_.publish(message);
  }
  void publish_front(int k) {
    sensor_msgs::PointCloud2 cloud = *room_cloud(k);
    cloud.header.frame_id = "front";
    harness_.publish(cloud);
  }
  ros::Time publish_rear(int k, const std::string& frame) {
    sensor_msgs::PointCloud2 cloud = *room_cloud(k);
    cloud.header.frame_id = frame;
    cloud.header.stamp += ros::Duration(0.05);
    rear_.publish(cloud);
    return cloud.header.stamp;
  }
  ros::NodeHandle nh_;
  ros::Publisher rear_, tf_;
  NodeHarness harness_;
};

TEST_F(Lidars, MakeOneMapAndNoneWaitsForTheOther) {
  publish_transform(0, "front", 0);
  publish_transform(0, "rear", 30);  // both stand in a room of their own
  for (int k = 1; k < 6; ++k) {
    publish_transform(k + 1, "front", 0);
    publish_transform(k + 1, "rear", 30);
    publish_front(k);
    const ros::Time rear_stamp = publish_rear(k, "rear");
    ASSERT_NE(harness_.answer(room_stamp(k)), nullptr);
    const Answer* rear = harness_.answer(rear_stamp);
    ASSERT_NE(rear, nullptr);
    EXPECT_EQ(rear->labelled_points->header.frame_id, "rear");
  }
  for (const double wall : {4.99, 34.99}) {  // seen by one, by the other
    ExplainPoint call;
    call.request.point.x = wall;
    call.request.point.y = 0.04;
    ASSERT_TRUE(ros::service::call("/stillmap/explain_point", call));
    EXPECT_TRUE(call.response.in_map) << call.response.message;
    EXPECT_EQ(call.response.label, 1) << call.response.message;
  }

  publish_rear(6, "loose");  // a LiDAR without a transform
  EXPECT_TRUE(harness_.said("/rear: 1 scans wait for their pose: tf2 has no odom <- loose"));
  publish_transform(8, "front", 0);
  publish_front(7);
  EXPECT_NE(harness_.answer(room_stamp(7)), nullptr) << "the other one goes on";
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "lidars_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
