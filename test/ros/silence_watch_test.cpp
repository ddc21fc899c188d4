#include "ros/silence_watch.hpp"

#include <gtest/gtest.h>

namespace stillmap {
namespace {

using std::chrono::seconds;

const ListenedTopic kClouds{"/cloud_registered", "sensor_msgs/PointCloud2", "cloud_topic"};

TEST(SilenceWatch, WarnsAfterFiveSecondsThenAtEachDoubling) {
  const SilenceWatch::Clock::time_point start;
  SilenceWatch watch(start);
  EXPECT_FALSE(watch.due(start + seconds(4)));
  EXPECT_EQ(watch.due(start + seconds(5)), seconds(5));
  EXPECT_FALSE(watch.due(start + seconds(9)));
  EXPECT_EQ(watch.due(start + seconds(10)), seconds(10));
  EXPECT_FALSE(watch.due(start + seconds(19)));
  watch.heard(start + seconds(19));
  EXPECT_FALSE(watch.due(start + seconds(23)));
  EXPECT_EQ(watch.due(start + seconds(24)), seconds(5));
}

TEST(WhySilent, NamesTheTopicsOfTheTypeButNotTheNodesOwn) {
  const ros::master::V_TopicInfo published = {{"/points", "sensor_msgs/PointCloud2"},
                                              {"/stillmap/static_points", "sensor_msgs/PointCloud2"},
                                              {"/Odometry", "nav_msgs/Odometry"}};
  EXPECT_EQ(why_silent(kClouds, 0, published, "/stillmap/"),
            "nobody publishes it; sensor_msgs/PointCloud2 are on /points; set cloud_topic");
}

TEST(WhySilent, SaysWhenThereIsNothingToChoose) {
  EXPECT_EQ(why_silent(kClouds, 0, {}, "/stillmap/"),
            "nobody publishes it; there is no other sensor_msgs/PointCloud2; start the publisher or the "
            "recording, or set cloud_topic");
}

TEST(WhySilent, TellsASilentPublisherFromNone) {
  const ros::master::V_TopicInfo published = {{"/cloud_registered", "sensor_msgs/PointCloud2"}};
  EXPECT_EQ(why_silent(kClouds, 1, published, "/stillmap/"),
            "it has a publisher, which is silent; there is no other sensor_msgs/PointCloud2; see whether the "
            "publisher or the recording stands still, or set cloud_topic");
}

TEST(WhySilent, NamesAnotherType) {
  const ros::master::V_TopicInfo published = {{"/cloud_registered", "sensor_msgs/LaserScan"}};
  EXPECT_EQ(why_silent(kClouds, 0, published, "/stillmap/"),
            "it is a sensor_msgs/LaserScan, not a sensor_msgs/PointCloud2; set cloud_topic to another topic");
}

}  // namespace
}  // namespace stillmap
