#pragma once

#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include "messages/bag_writer.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {

inline Frame frame_at(int k) {
  Frame frame;
  frame.scan.stamp_ns = k * 100'000'000LL;
  frame.scan.points = {{1, 2, 3}, {0, 0, 0}, {static_cast<float>(k), -4, 0.5F}};
  frame.T_map_sensor =
      Eigen::Translation3d(10.0 * k, 1, 2) * Eigen::AngleAxisd(0.3 * k, Eigen::Vector3d::UnitZ());
  return frame;
}

inline std::int64_t stamp_in_bag_ns(int k) {
  return std::int64_t{BagWriter::kBagEpoch_s} * 1'000'000'000 + frame_at(k).scan.stamp_ns;
}

/// Writes a bag and adds to it.
struct BagTest : testing::Test {
  TemporaryFolder folder;
  const std::string file = folder.path("a.bag");

  void write(const BagTopics& topics = {}, int scans = 4) {
    BagWriter bag(file, topics);
    for (int k = 0; k < scans; ++k) bag.write(frame_at(k), {{1, 2, 3}, {0, 1, 2}, {9, 0, 252}});
  }
  template <class Message>
  void append(const std::string& topic, Message message, int k) {
    rosbag::Bag bag(file, std::filesystem::exists(file) ? rosbag::bagmode::Append : rosbag::bagmode::Write);
    message.header.stamp.fromNSec(static_cast<std::uint64_t>(stamp_in_bag_ns(k)));
    bag.write(topic, message.header.stamp, message);
  }
};

}  // namespace stillmap
