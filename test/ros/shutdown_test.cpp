// Ctrl-C: the node finishes its queue, saves the map and leaves with exit code 0.

#include <gtest/gtest.h>
#include <ros/init.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

TEST(Shutdown, FinishesTheQueueAndSavesTheMap) {
  const std::string map = (std::filesystem::temp_directory_path() / "stillmap_shutdown_").string() +
                          std::to_string(getpid()) + ".pcd";
  const std::string save_map = "_save_map:=" + map;
  const pid_t node = fork();
  if (node == 0) {
    execl(STILLMAP_NODE, STILLMAP_NODE, "__name:=stillmap", "_cloud_frame:=sensor", "_save_map_idle_s:=1000",
          save_map.c_str(), nullptr);
    _exit(127);
  }
  NodeHarness harness;
  ASSERT_TRUE(harness.wait_for_connections());
  for (int k = 0; k < 8; ++k) {
    harness.publish(room_odometry(k));
    harness.publish(*room_cloud(k));
  }
  ASSERT_NE(harness.answer(room_odometry(3).header.stamp), nullptr);
  EXPECT_FALSE(std::filesystem::exists(map));
  kill(node, SIGINT);
  int status = -1;
  ASSERT_EQ(waitpid(node, &status, 0), node);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_TRUE(std::filesystem::exists(map));
  std::filesystem::remove(map);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "shutdown_test", ros::init_options::NoSigintHandler);
  return RUN_ALL_TESTS();
}
