// What others do with the outputs, with their own tools: OctoMap's and PCL's converters, rosbag,
// dynamic_reconfigure, and nodelets in the same process. The nodelet is loaded into this one.

#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <octomap/OcTree.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <signal.h>
#include <stillmap/LabelledMap.h>
#include <stillmap/SaveMap.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "messages/octomap_message.hpp"
#include "ros/node_harness.hpp"
#include "ros/node_interface.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

/// Runs a program to its end; true when it says that all went well.
bool run(const std::string& command) {
  return std::system(command.c_str()) == 0;
}

class Clients : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    loader = new nodelet::Loader(false);
    ASSERT_TRUE(loader->load("/stillmap", "stillmap/StillmapNodelet", {}, {}));
    harness = new NodeHarness;
    ASSERT_TRUE(harness->wait_until([] { return true; }));
  }
  static void TearDownTestSuite() {
    delete harness;
    delete loader;
  }

  /// Sends a scan of the room and waits for its labels.
  const Answer* send() {
    ++k;
    harness->publish(room_odometry(k));
    harness->publish(*room_cloud(k));
    return harness->answer(room_stamp(k));
  }
  std::string saved(const std::string& name) {
    SaveMap save;
    save.request.path = folder_.path(name);
    for (int i = 0; i < 4; ++i) EXPECT_NE(send(), nullptr);  // until something is known to stand
    EXPECT_TRUE(ros::service::call("/stillmap/save_map", save));
    EXPECT_TRUE(save.response.success) << save.response.message;
    return save.request.path;
  }

  TemporaryFolder folder_;
  static nodelet::Loader* loader;
  static NodeHarness* harness;
  static int k;
};
nodelet::Loader* Clients::loader = nullptr;
NodeHarness* Clients::harness = nullptr;
int Clients::k = 0;

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
  ASSERT_TRUE(harness->wait_until([&] {
    return publisher.getNumSubscribers() > 0 && a.getNumPublishers() > 0 && b.getNumPublishers() > 0;
  }));
  const sensor_msgs::PointCloud2Ptr cloud = room_cloud(++k);
  publisher.publish(cloud);
  // It waits for its pose in the node, and so this is not the only owner.
  EXPECT_TRUE(harness->wait_until([&] { return cloud.use_count() == 2; })) << cloud.use_count();
  harness->publish(room_odometry(k));
  ASSERT_TRUE(harness->wait_until([&] { return first && second; }));
  EXPECT_EQ(first.get(), second.get());
}

TEST_F(Clients, OctoMapsToolsReadTheMap) {
  ASSERT_NE(send(), nullptr);
  const std::string bt = saved("map.bt"), ot = folder_.path("map.ot");
  EXPECT_TRUE(run("convert_octree " + bt + " " + ot));
  EXPECT_GT(fs::file_size(ot), 1000u);
}

// The message as octomap_msgs::binaryMsgToMap() reads it, written as a file that OctoMap's tools read.
TEST_F(Clients, OctoMapsToolsReadTheTopic) {
  boost::shared_ptr<const OctomapMessage> message;
  const boost::function<void(const boost::shared_ptr<const OctomapMessage>&)> keep =
      [&](const boost::shared_ptr<const OctomapMessage>& m) { message = m; };
  const auto subscriber = ros::NodeHandle().subscribe<OctomapMessage>("/stillmap/octomap", 1, keep);
  ASSERT_NE(send(), nullptr);
  ASSERT_TRUE(harness->wait_until([&] { return message != nullptr; }));
  EXPECT_EQ(message->id, "OcTree");
  octomap::OcTree tree(message->resolution);
  std::stringstream data(std::string(message->data.begin(), message->data.end()));
  ASSERT_TRUE(tree.readBinaryData(data).good());
  EXPECT_GT(tree.getNumLeafNodes(), 1000u);
  const std::string bt = folder_.path("topic.bt"), ot = folder_.path("topic.ot");
  ASSERT_TRUE(tree.writeBinary(bt));
  EXPECT_TRUE(run("convert_octree " + bt + " " + ot));
  EXPECT_GT(fs::file_size(ot), 1000u);
}

TEST_F(Clients, PclsToolsReadTheMap) {
  ASSERT_NE(send(), nullptr);
  const std::string pcd = saved("map.pcd"), ply = saved("map.ply");
  EXPECT_TRUE(run("pcl_pcd2ply " + pcd + " " + folder_.path("from_pcd.ply")));
  EXPECT_TRUE(run("pcl_ply2pcd " + ply + " " + folder_.path("from_ply.pcd")));
  EXPECT_GT(fs::file_size(folder_.path("from_pcd.ply")), 10'000u);
  EXPECT_GT(fs::file_size(folder_.path("from_ply.pcd")), 10'000u);
}

// Every output with its type's checksum; rostopic reads a message by the definition in the bag alone.
TEST_F(Clients, RosbagRecordsAndPlaysEveryOutput) {
  const std::map<std::string, std::string> types = {{"static_points", "sensor_msgs/PointCloud2"},
                                                    {"dynamic_points", "sensor_msgs/PointCloud2"},
                                                    {"uncertain_points", "sensor_msgs/PointCloud2"},
                                                    {"labelled_points", "sensor_msgs/PointCloud2"},
                                                    {"sensor_odometry", "nav_msgs/Odometry"},
                                                    {"status", "stillmap/Status"},
                                                    {"static_map", "sensor_msgs/PointCloud2"},
                                                    {"map", "stillmap/LabelledMap"},
                                                    {"octomap", "octomap_msgs/Octomap"}};
  const std::string file = folder_.path("outputs.bag");
  ASSERT_TRUE(run("rosbag record --quiet -e '/stillmap/.*' -O " + file + " __name:=record & echo $! > " +
                  folder_.path("pid")));
  const auto recorded = [&] { return std::system(("test -e " + file + ".active").c_str()) == 0; };
  ASSERT_TRUE(harness->wait_until(recorded, 60));
  for (int i = 0; i < 20; ++i) {
    ASSERT_NE(send(), nullptr);
    harness->wait_until([] { return false; }, 0.2);
  }
  const pid_t recorder = std::stoi(read_text(folder_.path("pid")));
  kill(recorder, SIGINT);
  ASSERT_TRUE(harness->wait_until([&] { return fs::exists(file); }, 60));
  rosbag::Bag bag(file);
  for (const auto& [name, type] : types) {
    rosbag::View view(bag, rosbag::TopicQuery("/stillmap/" + name));
    ASSERT_GT(view.size(), 0u) << name;
    EXPECT_EQ(view.getConnections().front()->datatype, type);
  }
  rosbag::View octomaps(bag, rosbag::TopicQuery("/stillmap/octomap"));
  EXPECT_EQ(octomaps.getConnections().front()->md5sum, "9a45536b45c5e409cd49f04bb2d9999f");
  bag.close();
  EXPECT_TRUE(run("rostopic echo -b " + file + " -n 1 --noarr /stillmap/octomap | grep -q 'id: \"OcTree\"'"));

  std::size_t played = 0;
  const boost::function<void(const LabelledMapConstPtr&)> count_maps = [&](const LabelledMapConstPtr&) {
    ++played;
  };
  const auto subscriber = ros::NodeHandle().subscribe<LabelledMap>("/played/map", 10, count_maps);
  EXPECT_TRUE(run("rosbag play --quiet -r 20 --wait-for-subscribers --topics /stillmap/map --bags=" + file +
                  " /stillmap/map:=/played/map > /dev/null"));
  EXPECT_TRUE(harness->wait_until([&] { return played > 0; }));
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
  ASSERT_TRUE(harness->wait_until(is(1.0), 60));
  const Answer* after = send();
  ASSERT_NE(after, nullptr);
  EXPECT_LT(after->status->static_points, before_points);
  EXPECT_TRUE(set("{'p_static_min': 0.7}"));
  ASSERT_TRUE(harness->wait_until(is(0.7), 60));
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
