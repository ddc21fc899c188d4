// The master goes away while a node runs: it goes on with the topics that are connected, also after a
// silence.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <ros/init.h>
#include <sys/socket.h>

#include <cstdlib>

#include "ros/child_process.hpp"
#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

std::string free_port() {
  const int socket_of_any = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  bind(socket_of_any, reinterpret_cast<sockaddr*>(&address), size);
  getsockname(socket_of_any, reinterpret_cast<sockaddr*>(&address), &size);
  close(socket_of_any);
  return std::to_string(ntohs(address.sin_port));
}

void expect_answer(NodeHarness& harness, int k) {
  harness.publish(room_odometry(k));
  harness.publish(*room_cloud(k));
  EXPECT_NE(harness.answer(room_stamp(k)), nullptr) << "scan " << k;
}

TEST(MasterGone, TheNodeGoesOnAlsoAfterASilence) {
  const std::string port = free_port();
  setenv("ROS_MASTER_URI", ("http://localhost:" + port).c_str(), 1);
  auto master = std::make_unique<ChildProcess>(std::vector<std::string>{"rosmaster", "--core", "-p", port});
  int argc = 0;
  ros::init(argc, nullptr, "master_gone_test");
  NodeHarness harness;  // waits for the master
  const ChildProcess node({STILLMAP_NODE, "__name:=stillmap", "_cloud_frame:=sensor"});
  ASSERT_TRUE(harness.wait_for_connections());
  expect_answer(harness, 0);
  master.reset();
  expect_answer(harness, 1);
  harness.wait_until([] { return false; }, 7);  // long enough for the node to look for what is silent
  expect_answer(harness, 70);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
