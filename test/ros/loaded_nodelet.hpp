#pragma once

#include <gtest/gtest.h>
#include <nodelet/loader.h>

#include <memory>

#include "ros/node_harness.hpp"

namespace stillmap {

/// The nodelet /stillmap in the test's own process, for all tests of a program.
class LoadedNodelet : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    loader_ = std::make_unique<nodelet::Loader>(false);
    ASSERT_TRUE(loader_->load("/stillmap", "stillmap/StillmapNodelet", {}, {}));
    harness_ = std::make_unique<NodeHarness>();
    ASSERT_TRUE(harness_->wait_for_connections(1));
  }
  static void TearDownTestSuite() {
    harness_.reset();
    loader_.reset();
  }

  /// Sends the next scan of the room and waits for its labels.
  static const Answer* send() {
    ++scan_;
    harness_->publish(room_odometry(scan_));
    harness_->publish(*room_cloud(scan_));
    return harness_->answer(room_stamp(scan_));
  }

  inline static std::unique_ptr<nodelet::Loader> loader_;
  inline static std::unique_ptr<NodeHarness> harness_;
  inline static int scan_ = 0;
};

/// Runs a program to its end; true when it says that all went well.
inline bool run(const std::string& command) {
  return std::system(command.c_str()) == 0;
}

}  // namespace stillmap
