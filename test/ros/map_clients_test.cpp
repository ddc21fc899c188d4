// OctoMap's and PCL's own tools read the maps.

#include <gtest/gtest.h>
#include <octomap/OcTree.h>
#include <ros/ros.h>
#include <stillmap/SaveMap.h>

#include <filesystem>
#include <sstream>

#include "messages/octomap_message.hpp"
#include "ros/loaded_nodelet.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

class MapClients : public LoadedNodelet {
 protected:
  std::string saved(const std::string& name) {
    SaveMap save;
    save.request.path = folder_.path(name);
    for (int i = 0; i < 4; ++i) EXPECT_NE(send(), nullptr);  // until something is known to stand
    EXPECT_TRUE(ros::service::call("/stillmap/save_map", save));
    EXPECT_TRUE(save.response.success) << save.response.message;
    return save.request.path;
  }

  TemporaryFolder folder_;
};

TEST_F(MapClients, OctoMapsToolsReadTheMap) {
  ASSERT_NE(send(), nullptr);
  const std::string bt = saved("map.bt"), ot = folder_.path("map.ot");
  EXPECT_TRUE(run("convert_octree " + bt + " " + ot));
  EXPECT_GT(fs::file_size(ot), 1000u);
}

// The message as octomap_msgs::binaryMsgToMap() reads it, written as a file that OctoMap's tools read.
TEST_F(MapClients, OctoMapsToolsReadTheTopic) {
  boost::shared_ptr<const OctomapMessage> message;
  const boost::function<void(const boost::shared_ptr<const OctomapMessage>&)> keep =
      [&](const boost::shared_ptr<const OctomapMessage>& m) { message = m; };
  const auto subscriber = ros::NodeHandle().subscribe<OctomapMessage>("/stillmap/octomap", 1, keep);
  ASSERT_NE(send(), nullptr);
  ASSERT_TRUE(harness_->wait_until([&] { return message != nullptr; }));
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

TEST_F(MapClients, PclsToolsReadTheMap) {
  ASSERT_NE(send(), nullptr);
  const std::string pcd = saved("map.pcd"), ply = saved("map.ply");
  EXPECT_TRUE(run("pcl_pcd2ply " + pcd + " " + folder_.path("from_pcd.ply")));
  EXPECT_TRUE(run("pcl_ply2pcd " + ply + " " + folder_.path("from_ply.pcd")));
  EXPECT_GT(fs::file_size(folder_.path("from_pcd.ply")), 10'000u);
  EXPECT_GT(fs::file_size(folder_.path("from_ply.pcd")), 10'000u);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "map_clients_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
