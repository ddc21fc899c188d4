// Parameters that are refused by name, and a manager that outlives them.

#include <gtest/gtest.h>
#include <nodelet/NodeletLoad.h>
#include <ros/init.h>
#include <ros/service.h>

#include <stdexcept>

#include "messages/expect_message.hpp"
#include "ros/node_harness.hpp"
#include "ros/parameter_server.hpp"

namespace stillmap {
namespace {

/// Parameters in a namespace that lasts as long as this.
struct Given {
  ros::NodeHandle nh;
  explicit Given(const std::string& name_space) : nh(name_space) {}
  ~Given() { nh.deleteParam(nh.getNamespace()); }
};

template <class Value>
void expect_refused(const std::string& name, const Value& value, const std::string& words) {
  Given given("/refused");
  given.nh.setParam(name, value);
  expect_message<std::runtime_error>([&] { load_settings(given.nh); }, words);
}

TEST(Parameters, AreTakenFromTheServer) {
  Given given("/given");
  given.nh.setParam("preset", "paper");
  given.nh.setParam("max_range_m", 50);  // a whole number is a number, too
  given.nh.setParam("conflict_strength", "sigmoid");
  given.nh.setParam("support_rate", std::vector<double>{0.1, 0.2, 0.3});
  given.nh.setParam("cloud_frame", "body");
  given.nh.setParam("sensor_on_body", std::vector<double>{0, 0, 0.28, 0, 0, 0});
  const NodeSettings settings = load_settings(given.nh);
  EXPECT_EQ(settings.method.voxel_size_m, preset("paper").voxel_size_m);
  EXPECT_EQ(settings.method.max_range_m, 50.0);
  EXPECT_EQ(settings.method.conflict_strength, "sigmoid");
  EXPECT_EQ(settings.method.support_rate_r, (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(settings.node.cloud_frame, "body");
  EXPECT_EQ(check_node_parameters(settings.node).T_body_sensor.translation().z(), 0.28);
}

TEST(Parameters, WhatIsGivenGoesBeforeThePreset) {
  Given given("/given");
  given.nh.setParam("odometry_preset", "sc_pgo");
  given.nh.setParam("odom_topic", "/mine");
  const NodeParameters node = load_settings(given.nh).node;
  EXPECT_EQ(node.cloud_topic, "/velodyne_cloud_registered_local");
  EXPECT_EQ(node.cloud_frame, "sensor");
  EXPECT_EQ(node.max_odometry_gap_s, 3.0);
  EXPECT_EQ(node.queue_size, 50);
  EXPECT_EQ(node.odom_topic, "/mine");
}

TEST(Parameters, AreRefusedByName) {
  expect_refused("odometry_preset", "alaom",
                 "odometry_preset: 'alaom' is not one of aloam|dlio|fast_lio|generic|");
  expect_refused("odometry_axes", "camera", "odometry_axes: 'camera' is not one of ros|loam");
  expect_refused("voxel_size_m", -1.0, "voxel_size_m: -1 is not in [0.02, 2] m");
  expect_refused("voxel_size", 0.1, "/refused: voxel_size: unknown parameter; did you mean voxel_size_m?");
  expect_refused("cloud_topik", "/a", "did you mean cloud_topic?");
  expect_refused("max_range_m", "far", "max_range_m: 'far' is not a number");
  expect_refused("preset", "papers", "preset: 'papers' is not one of");
  expect_refused("queue_size", 0, "queue_size: 0 is not in [1, 1000]");
  expect_refused("queue_size", 2.5, "queue_size: '2.5' is not a whole number");
  expect_refused("map_period_s", "often", "map_period_s: 'often' is not a number");
  expect_refused("cloud_frame", "lidar", "cloud_frame: 'lidar' is not one of world|body|sensor");
  expect_refused("sensor_on_body", "1 2", "sensor_on_body: '1 2' is not");
  expect_refused("odom_topic", "", "fixed_frame: needed when odom_topic is empty");
}

bool load_nodelet(const std::string& name) {
  nodelet::NodeletLoad load;
  load.request.type = "stillmap/StillmapNodelet";
  load.request.name = name;
  return ros::service::call("/manager/load_nodelet", load);
}

TEST(Manager, OutlivesARefusedNodelet) {
  NodeHarness harness;
  ASSERT_TRUE(ros::service::waitForService("/manager/load_nodelet", ros::Duration(30)));
  ASSERT_TRUE(load_nodelet("/stillmap"));
  ASSERT_TRUE(harness.wait_for_connections());
  Given given("/refused");
  given.nh.setParam("voxel_size_m", 5.0);
  load_nodelet("/refused");
  EXPECT_TRUE(harness.said("parameters of /refused: the method's parameters: voxel_size_m: 5 is not in"));
  harness.publish(room_odometry(0));
  harness.publish(*room_cloud(0));
  EXPECT_NE(harness.answer(room_odometry(0).header.stamp), nullptr);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "refused_parameters_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
