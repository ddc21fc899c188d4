// Whatever comes in, the node says what is wrong, goes on, and keeps its map.

#include <gtest/gtest.h>
#include <ros/init.h>

#include <limits>

#include "messages/make_cloud.hpp"
#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

class BadInput : public testing::Test {
 protected:
  static void SetUpTestSuite() { harness = new NodeHarness; }
  static void TearDownTestSuite() { delete harness; }

  void SetUp() override {
    ASSERT_TRUE(harness->wait_for_connections());
    expect_good_scan();
    voxels_before_ = voxels_;
    harness->forget_what_was_said();
  }
  // The node lives, and the map is what it was: the room does not change.
  void TearDown() override {
    expect_good_scan();
    EXPECT_EQ(voxels_, voxels_before_);
  }

  void expect_good_scan() {
    ++k;
    harness->publish(room_odometry(k));
    harness->publish(*room_cloud(k));
    const Answer* answer = harness->answer(room_odometry(k).header.stamp);
    ASSERT_NE(answer, nullptr);
    voxels_ = answer->status->voxels;
    EXPECT_GT(voxels_, 0u);
  }
  void send(const sensor_msgs::PointCloud2& cloud) {
    harness->publish(room_odometry(k));
    harness->publish(cloud);
  }

  /// The answer to a cloud that holds the room in another form: every row judged, in that form.
  void expect_room(const sensor_msgs::PointCloud2& cloud) {
    const Answer* answer = harness->answer(cloud.header.stamp);
    ASSERT_NE(answer, nullptr);
    EXPECT_EQ(answer->status->invalid_points, 0u);
    EXPECT_EQ(answer->status->voxels, voxels_before_);
    EXPECT_EQ(answer->labelled_points->is_bigendian, cloud.is_bigendian);
    EXPECT_GT(answer->static_points->width, cloud.width * 9 / 10);
  }

  static NodeHarness* harness;
  static int k;
  std::uint64_t voxels_ = 0, voxels_before_ = 0;
};
NodeHarness* BadInput::harness = nullptr;
int BadInput::k = 0;

TEST_F(BadInput, EmptyCloud) {
  sensor_msgs::PointCloud2 cloud = *room_cloud(++k);
  cloud.width = 0;
  cloud.row_step = 0;
  cloud.data.clear();
  send(cloud);
  EXPECT_TRUE(harness->said("/cloud_registered: a scan has no rows; the map stays as it is"));
}

TEST_F(BadInput, AllRowsNaN) {
  sensor_msgs::PointCloud2 cloud = *room_cloud(++k);
  std::fill(cloud.data.begin(), cloud.data.end(), 0xFF);
  send(cloud);
  const Answer* answer = harness->answer(cloud.header.stamp);
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->uncertain_points->width, cloud.width);
  EXPECT_EQ(answer->status->invalid_points, cloud.width);
  EXPECT_TRUE(harness->said("/cloud_registered: a scan of 5760 rows has no usable return"));
}

// Misread coordinates would be invalid, or show as voxels outside the room's walls.
TEST_F(BadInput, Float64IsConverted) {
  const sensor_msgs::PointCloud2Ptr cloud = make_cloud<double>(room_points(), room_stamp(++k).toNSec());
  send(*cloud);
  expect_room(*cloud);
}

TEST_F(BadInput, BigEndianIsConverted) {
  sensor_msgs::PointCloud2 cloud = *room_cloud(++k);
  make_bigendian(cloud);
  send(cloud);
  expect_room(cloud);
}

TEST_F(BadInput, BigEndianFloat64IsConverted) {
  const sensor_msgs::PointCloud2Ptr cloud = make_cloud<double>(room_points(), room_stamp(++k).toNSec());
  make_bigendian(*cloud);
  send(*cloud);
  expect_room(*cloud);
}

TEST_F(BadInput, NoCoordinates) {
  sensor_msgs::PointCloud2 cloud = *room_cloud(++k);
  cloud.fields[0].name = "range";
  send(cloud);
  EXPECT_TRUE(harness->said("/cloud_registered: a scan is dropped: there is no field 'x'"));
}

TEST_F(BadInput, OdometryNotFinite) {
  nav_msgs::Odometry odometry = room_odometry(k + 1);
  odometry.pose.pose.position.y = std::numeric_limits<double>::infinity();
  harness->publish(odometry);
  EXPECT_TRUE(harness->said("/Odometry: a pose is not used: a number of the pose is not finite"));
}

TEST_F(BadInput, OdometryNotOfUnitLength) {
  nav_msgs::Odometry odometry = room_odometry(k + 1);
  odometry.pose.pose.orientation.w = 0.5;
  EXPECT_TRUE(harness->wait_until([&] {  // again and again: the warning before it may hold it back
    harness->publish(odometry);
    return harness->said("/Odometry: a pose is not used: the quaternion has length 0.5", 0.2);
  }));
}

TEST_F(BadInput, StampsJumpBack) {
  k -= 1000;
  expect_good_scan();
  EXPECT_TRUE(harness->said("/cloud_registered: the stamps jumped back by 99."));
}

TEST_F(BadInput, NoPose) {
  sensor_msgs::PointCloud2 cloud = *room_cloud(++k);
  harness->publish(cloud);
  EXPECT_TRUE(harness->said("scans wait for their pose: the newest odometry is 0.100000 s older"));
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "bad_input_test");
  return RUN_ALL_TESTS();
}
