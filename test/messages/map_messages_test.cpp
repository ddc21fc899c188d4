#include "messages/map_messages.hpp"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <sstream>

#include "messages/point_cloud_conversion.hpp"

namespace stillmap {
namespace {

MapSnapshot make_map() {
  MapSnapshot map;
  map.stamp_ns = 1'600'000'000'500'000'000;
  map.voxel_size_m = 0.1;
  map.voxels = {{{1.05f, 2.05f, 0.05f}, 2.0f, Label::kStatic},
                {{3.05f, 2.05f, 0.05f}, -2.0f, Label::kDynamic},
                {{5.05f, 2.05f, 0.05f}, 0.1f, Label::kUncertain}};
  return map;
}

TEST(MapMessages, TheLabelledMapHoldsEveryVoxel) {
  const auto message = to_labelled_map(make_map(), "camera_init");
  EXPECT_EQ(message->header.frame_id, "camera_init");
  EXPECT_EQ(message->header.stamp.toNSec(), 1'600'000'000'500'000'000u);
  EXPECT_EQ(message->voxel_size_m, 0.1);
  ASSERT_EQ(message->centers.size(), 9u);
  EXPECT_EQ(message->centers[3], 3.05f);
  EXPECT_EQ(message->log_odds[1], -2.0f);
  EXPECT_EQ(message->labels, (std::vector<std::uint8_t>{1, 2, 0}));
}

TEST(MapMessages, TheStaticCloudHoldsTheStaticVoxelsOnly) {
  const auto cloud = to_static_cloud(make_map(), "camera_init");
  Scan scan;
  to_scan(*cloud, scan);
  ASSERT_EQ(scan.points.size(), 1u);
  EXPECT_EQ(scan.points[0], Eigen::Vector3f(1.05f, 2.05f, 0.05f));
  EXPECT_EQ(row_count(*to_static_cloud(MapSnapshot(), "map")), 0u);
}

// As octomap_msgs' own conversion reads it.
TEST(MapMessages, TheOctomapReadsBack) {
  const auto message = to_octomap_message(make_map(), "camera_init");
  ASSERT_EQ(message->id, "OcTree");
  ASSERT_TRUE(message->binary);
  octomap::OcTree tree(message->resolution);
  std::stringstream stream;
  stream.write(reinterpret_cast<const char*>(message->data.data()), message->data.size());
  tree.readBinaryData(stream);
  const octomap::OcTreeNode* node = tree.search(1.05, 2.05, 0.05);
  ASSERT_NE(node, nullptr);
  EXPECT_TRUE(tree.isNodeOccupied(node));
  const octomap::OcTreeNode* seen_through = tree.search(3.05, 2.05, 0.05);
  EXPECT_TRUE(seen_through == nullptr || !tree.isNodeOccupied(seen_through));
}

TEST(MapMessages, TheOctomapIsTheWireType) {
  using Message = OctomapMessage;
  EXPECT_STREQ(ros::message_traits::datatype<Message>(), "octomap_msgs/Octomap");
  EXPECT_STREQ(ros::message_traits::md5sum<Message>(), "9a45536b45c5e409cd49f04bb2d9999f");
  const Message sent = *to_octomap_message(make_map(), "camera_init");
  const ros::SerializedMessage bytes = ros::serialization::serializeMessage(sent);
  Message received;
  ros::serialization::deserializeMessage(bytes, received);
  EXPECT_EQ(received.data, sent.data);
  EXPECT_EQ(received.resolution, 0.1);
}

}  // namespace
}  // namespace stillmap
