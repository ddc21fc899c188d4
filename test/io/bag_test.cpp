#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstring>

#include "io/written_bag.hpp"
#include "messages/bag_sequence.hpp"
#include "support/expect_error.hpp"

namespace stillmap {
namespace {

nav_msgs::Odometry odometry(double x = 0, double qw = 1) {
  nav_msgs::Odometry odometry;
  odometry.pose.pose.position.x = x;
  odometry.pose.pose.orientation.w = qw;
  return odometry;
}

TEST_F(BagTest, WorldAndSensorCloudsGiveTheScanBack) {
  for (const bool world : {true, false}) {
    BagTopics topics;
    topics.world_clouds = world;
    write(topics);
    BagInput input;
    input.pairing.cloud_frame = world ? CloudFrame::kWorld : CloudFrame::kSensor;
    BagSequence sequence(file, input);
    ASSERT_EQ(sequence.size(), 4u);
    for (const int k : {3, 0, 2, 1}) {  // any order
      const Frame frame = sequence.read(static_cast<std::size_t>(k)), expected = frame_at(k);
      EXPECT_EQ(frame.name, "00000" + std::to_string(k));
      EXPECT_EQ(frame.scan.stamp_ns, stamp_in_bag_ns(k));
      EXPECT_TRUE(frame.T_map_sensor.isApprox(expected.T_map_sensor, 1e-12));
      ASSERT_EQ(frame.scan.points.size(), expected.scan.points.size());
      for (std::size_t i = 0; i < frame.scan.points.size(); ++i)
        EXPECT_LT((frame.scan.points[i] - expected.scan.points[i]).norm(), world ? 1e-5 : 1e-30);
      EXPECT_EQ(frame.scan.points[1], Eigen::Vector3f(0, 0, 0));
    }
    EXPECT_TRUE(sequence.warnings().empty());
  }
}

TEST_F(BagTest, WritesAllFieldsPoseAndTransformOfOneStamp) {
  write({}, 1);
  rosbag::Bag bag(file);
  std::size_t messages = 0;
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    ++messages;
    EXPECT_EQ(static_cast<std::int64_t>(message.getTime().toNSec()), stamp_in_bag_ns(0));
    const auto cloud = message.instantiate<sensor_msgs::PointCloud2>();
    if (!cloud) continue;
    EXPECT_EQ(cloud->width, 3u);
    std::string names;
    for (const auto& field : cloud->fields) names += field.name + " ";
    EXPECT_EQ(names, "x y z intensity ring label ");
    std::uint32_t label = 0;
    std::memcpy(&label, &cloud->data[2 * cloud->point_step + cloud->fields.back().offset], sizeof(label));
    EXPECT_EQ(label, 252u);
  }
  EXPECT_EQ(messages, 3u);
}

TEST_F(BagTest, RefusesFieldsOfAnotherSize) {
  BagWriter bag(file);
  expect_error<std::invalid_argument>(
      [&] {
        bag.write(frame_at(0), {{1, 2}, {}, {}});
      },
      {"intensity", "2 values"});
}

TEST_F(BagTest, PosesBetweenOdometryMessagesAreInterpolated) {
  BagTopics topics;
  topics.odometry = "/unused";
  topics.world_clouds = false;
  write(topics);
  append("/odom", odometry(0), 0);
  append("/odom", odometry(3), 3);
  BagInput input;
  input.odom_topic = "/odom";
  input.pairing.cloud_frame = CloudFrame::kSensor;
  BagSequence sequence(file, input);
  ASSERT_EQ(sequence.size(), 4u);
  EXPECT_NEAR(sequence.read(1).T_map_sensor.translation().x(), 1.0, 1e-9);
}

TEST_F(BagTest, CloudsWithoutAPoseAreLeftOutAndTold) {
  BagTopics topics;
  topics.odometry = "/unused";
  write(topics);
  append("/odom", odometry(), 1);
  append("/odom", odometry(0, 7), 2);  // no rotation
  BagInput input;
  input.odom_topic = "/odom";
  BagSequence sequence(file, input);
  ASSERT_EQ(sequence.size(), 1u);
  EXPECT_EQ(sequence.read(0).name, "000001");
  ASSERT_EQ(sequence.warnings().size(), 2u);
  EXPECT_NE(sequence.warnings()[0].find("/odom: 1 poses left out"), std::string::npos);
  EXPECT_NE(sequence.warnings()[1].find("3 of 4 clouds have no pose"), std::string::npos);
}

TEST_F(BagTest, RefusesABagWhoseClocksDiffer) {
  BagTopics topics;
  topics.odometry = "/unused";
  write(topics);
  append("/odom", odometry(), 900);
  BagInput input;
  input.odom_topic = "/odom";
  expect_error([&] { BagSequence(file, input); }, {"a.bag", "/cloud_registered", "4 of 4", "clock"});
}

TEST_F(BagTest, RefusesToGuessBetweenTopics) {
  write();
  append("/other_odometry", odometry(), 0);
  expect_error([&] { BagSequence(file, {}); }, {"/Odometry (4), /other_odometry (1)", "--odom-topic"});
  BagInput input;
  input.odom_topic = "/odo";
  expect_error([&] { BagSequence(file, input); }, {"no topic /odo", "/Odometry (4)"});
}

TEST_F(BagTest, RefusesABagWithoutThem) {
  append("/odom", odometry(), 0);
  expect_error([&] { BagSequence(file, {}); }, {"a.bag", "no topic of type sensor_msgs/PointCloud2"});
}

TEST_F(BagTest, RefusesWhatIsNoBag) {
  expect_error([&] { BagSequence(folder.write("b.bag", "no bag"), {}); }, {"b.bag", "not a readable bag"});
  expect_error([&] { BagWriter(folder.path("no/c.bag")); }, {"c.bag", "cannot be created"});
}

TEST_F(BagTest, AnUnreadableCloudIsNamed) {
  sensor_msgs::PointCloud2 cloud;
  cloud.width = cloud.height = 1;
  append("/cloud", cloud, 0);
  append("/odom", odometry(), 0);
  BagSequence sequence(file, {});
  expect_error([&] { sequence.read(0); }, {"a.bag", "/cloud", "cloud 0"});
}

}  // namespace
}  // namespace stillmap
