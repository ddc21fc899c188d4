// What others find of the node: its names, messages shared within a process, dynamic_reconfigure.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <map>
#include <set>

#include "ros/loaded_nodelet.hpp"
#include "ros/node_interface.hpp"

namespace stillmap {
namespace {

using Clients = LoadedNodelet;

/// What the master knows below /stillmap/, by name.
std::map<std::string, std::string> below_stillmap(const std::vector<Endpoint>& endpoints) {
  std::map<std::string, std::string> types;
  for (const Endpoint& endpoint : endpoints) types["/stillmap/" + endpoint.name] = endpoint.type;
  return types;
}

TEST_F(Clients, TheReferenceNamesEveryTopicAndService) {
  std::map<std::string, std::string> topics;
  ros::master::V_TopicInfo infos;
  ASSERT_TRUE(ros::master::getTopics(infos));
  for (const ros::master::TopicInfo& info : infos)
    if (info.name.rfind("/stillmap/", 0) == 0) topics[info.name] = info.datatype;
  EXPECT_EQ(topics, below_stillmap(published_topics())) << "src/ros/node_interface.cpp lists them";

  std::set<std::string> services, listed;
  XmlRpc::XmlRpcValue request, response, state;
  request[0] = ros::this_node::getName();
  ASSERT_TRUE(ros::master::execute("getSystemState", request, response, state, false));
  for (int i = 0; i < state[2].size(); ++i) {
    const std::string name = state[2][i][0];
    if (name.rfind("/stillmap/", 0) == 0) services.insert(name);
  }
  for (const auto& [name, type] : below_stillmap(offered_services())) listed.insert(name);
  EXPECT_EQ(services, listed) << "src/ros/node_interface.cpp lists them";
}

// The node holds the very message that was published, and its listeners in the process share one message.
TEST_F(Clients, NodeletsOfOneProcessShareTheirMessages) {
  ros::NodeHandle nh;
  sensor_msgs::PointCloud2ConstPtr first, second;
  const auto keep = [](sensor_msgs::PointCloud2ConstPtr& slot) {
    return boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)>(
        [&slot](const sensor_msgs::PointCloud2ConstPtr& cloud) { slot = cloud; });
  };
  const auto a = nh.subscribe<sensor_msgs::PointCloud2>("/stillmap/labelled_points", 1, keep(first));
  const auto b = nh.subscribe<sensor_msgs::PointCloud2>("/stillmap/labelled_points", 1, keep(second));
  ros::Publisher publisher = nh.advertise<sensor_msgs::PointCloud2>("/cloud_registered", 1);
  ASSERT_TRUE(harness_->wait_until([&] {
    return publisher.getNumSubscribers() > 0 && a.getNumPublishers() > 0 && b.getNumPublishers() > 0;
  }));
  const sensor_msgs::PointCloud2Ptr cloud = room_cloud(++scan_);
  publisher.publish(cloud);
  // It waits for its pose in the node, and so this is not the only owner.
  EXPECT_TRUE(harness_->wait_until([&] { return cloud.use_count() == 2; })) << cloud.use_count();
  harness_->publish(room_odometry(scan_));
  ASSERT_TRUE(harness_->wait_until([&] { return first && second; }));
  EXPECT_EQ(first.get(), second.get());
}

// As rqt_reconfigure does it.
TEST_F(Clients, DynamicReconfigureChangesTheDecision) {
  for (int i = 0; i < 3; ++i) ASSERT_NE(send(), nullptr);
  const Answer* before = send();
  ASSERT_NE(before, nullptr);
  const std::uint32_t before_points = before->status->static_points;
  EXPECT_GT(before_points, 5000u);
  const auto set = [](const std::string& changes) {
    return run(
        "/usr/bin/python3 -c \"import rospy, dynamic_reconfigure.client as c; rospy.init_node('set'); "
        "print(c.Client('/stillmap', timeout=30).update_configuration(" +
        changes + "))\" &");
  };
  const auto is = [](double wanted) {
    return [=] { return ros::NodeHandle("/stillmap").param("p_static_min", 0.0) == wanted; };
  };
  EXPECT_TRUE(set("{'p_static_min': 1.0}"));
  ASSERT_TRUE(harness_->wait_until(is(1.0), 60));
  const Answer* after = send();
  ASSERT_NE(after, nullptr);
  EXPECT_LT(after->status->static_points, before_points);
  EXPECT_TRUE(set("{'p_static_min': 0.7}"));
  ASSERT_TRUE(harness_->wait_until(is(0.7), 60));
  const Answer* again = send();
  ASSERT_NE(again, nullptr);
  EXPECT_GT(again->status->static_points, after->status->static_points);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "clients_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
