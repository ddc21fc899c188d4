// The map's topics and services.

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/init.h>
#include <ros/service.h>
#include <ros/topic.h>
#include <std_srvs/Trigger.h>
#include <stillmap/LabelledMap.h>
#include <stillmap/SaveMap.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "messages/octomap_message.hpp"
#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

class Services : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    harness = new NodeHarness;
    folder = fs::temp_directory_path() / ("stillmap_services_" + std::to_string(getpid()));
    fs::create_directory(folder);
    ASSERT_TRUE(harness->wait_for_connections());
    for (int k = 0; k < 8; ++k) {
      harness->publish(room_odometry(k));
      harness->publish(*room_cloud(k));
      ASSERT_NE(harness->answer(room_odometry(k).header.stamp), nullptr);
    }
  }
  static void TearDownTestSuite() {
    fs::remove_all(folder);
    delete harness;
  }

  SaveMap::Response save(const std::string& name, bool overwrite = false) {
    SaveMap call;
    call.request.path = (folder / name).string();
    call.request.overwrite = overwrite;
    EXPECT_TRUE(ros::service::call("/stillmap/save_map", call));
    return call.response;
  }
  /// The latched message of a topic, though it was not listened to before.
  template <class Message>
  boost::shared_ptr<const Message> latched(const std::string& topic) {
    boost::shared_ptr<const Message> message;
    const boost::function<void(const boost::shared_ptr<const Message>&)> keep =
        [&](const boost::shared_ptr<const Message>& received) { message = received; };
    const ros::Subscriber subscriber = ros::NodeHandle().subscribe<Message>(topic, 1, keep);
    harness->wait_until([&] { return message != nullptr; });
    return message;
  }

  static NodeHarness* harness;
  static fs::path folder;
};
NodeHarness* Services::harness = nullptr;
fs::path Services::folder;

TEST_F(Services, TheMapIsPublishedInThreeForms) {
  const auto map = latched<LabelledMap>("/stillmap/map");
  ASSERT_TRUE(map);
  EXPECT_EQ(map->header.frame_id, "camera_init");
  EXPECT_EQ(map->header.stamp, room_odometry(7).header.stamp);
  ASSERT_GT(map->labels.size(), 0u);
  EXPECT_EQ(map->centers.size(), 3 * map->labels.size());
  EXPECT_EQ(map->log_odds.size(), map->labels.size());
  const auto static_map = latched<sensor_msgs::PointCloud2>("/stillmap/static_map");
  ASSERT_TRUE(static_map);
  EXPECT_EQ(static_map->width, std::count(map->labels.begin(), map->labels.end(), LabelledMap::STATIC));
  const auto octomap = latched<OctomapMessage>("/stillmap/octomap");
  ASSERT_TRUE(octomap);
  EXPECT_EQ(octomap->resolution, map->voxel_size_m);
  EXPECT_FALSE(octomap->data.empty());
}

TEST_F(Services, SavesEveryFormatAndRefusesOthers) {
  for (const std::string name : {"map.pcd", "map.ply", "map.bt", "map.ot", "map.stillmap"}) {
    const SaveMap::Response response = save(name);
    EXPECT_TRUE(response.success) << response.message;
    EXPECT_GT(fs::file_size(folder / name), 100u) << name;
  }
  EXPECT_FALSE(save("map.las").success);
  const SaveMap::Response response = save("no_such_folder/map.pcd");
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("no_such_folder"), std::string::npos) << response.message;
}

TEST_F(Services, OverwritesNothingUnaskedAndWritesNowhereElse) {
  ASSERT_TRUE(save("twice.pcd").success);
  const SaveMap::Response kept = save("twice.pcd");
  EXPECT_FALSE(kept.success);
  EXPECT_NE(kept.message.find("is there already"), std::string::npos) << kept.message;
  EXPECT_TRUE(save("twice.pcd", true).success);
  const fs::perms mode = fs::status(folder / "twice.pcd").permissions();
  EXPECT_EQ(mode & (fs::perms::group_write | fs::perms::others_write), fs::perms::none);
  for (const char* path : {"/etc/stillmap_test.pcd", "../../../../../../etc/stillmap_test.pcd"}) {
    SaveMap elsewhere;
    elsewhere.request.path = path;
    ASSERT_TRUE(ros::service::call("/stillmap/save_map", elsewhere));
    EXPECT_FALSE(elsewhere.response.success);
    EXPECT_NE(elsewhere.response.message.find("outside of map_directory"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists("/etc/stillmap_test.pcd"));
}

TEST_F(Services, ReportsItselfOnDiagnostics) {
  const auto array = latched<diagnostic_msgs::DiagnosticArray>("/diagnostics");
  ASSERT_TRUE(array);
  std::set<std::string> names;
  for (const diagnostic_msgs::DiagnosticStatus& status : array->status) names.insert(status.name);
  EXPECT_EQ(names, (std::set<std::string>{"stillmap: scans", "stillmap: setup"}));
}

TEST_F(Services, SavesWhenTheScansCease) {
  const fs::path file = fs::path(ros::NodeHandle("/stillmap").param<std::string>("save_map", ""));
  EXPECT_TRUE(harness->wait_until([&] { return fs::exists(file); })) << file;
  fs::remove(file);
}

// The last: the others need the map.
TEST_F(Services, ResetForgetsTheMap) {
  std_srvs::Trigger call;
  ASSERT_TRUE(ros::service::call("/stillmap/reset", call));
  EXPECT_TRUE(call.response.success);
  EXPECT_NE(call.response.message.find("8 scans"), std::string::npos) << call.response.message;
  EXPECT_NE(save("empty.pcd").message.find("no static voxel"), std::string::npos);
  harness->publish(room_odometry(8));
  harness->publish(*room_cloud(8));
  const Answer* answer = harness->answer(room_odometry(8).header.stamp);
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->status->scans, 1u);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "services_test");
  return RUN_ALL_TESTS();
}
