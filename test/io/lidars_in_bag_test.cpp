#include "messages/lidars_in_bag.hpp"

#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>

#include "io/written_bag.hpp"

namespace stillmap {
namespace {

using LidarsInBagTest = BagTest;

TEST_F(LidarsInBagTest, TheirScansComeInTheOrderOfTheirStamps) {
  write();
  std::vector<sensor_msgs::PointCloud2> clouds;
  {
    rosbag::Bag bag(file);
    for (const rosbag::MessageInstance& message : rosbag::View(bag, rosbag::TopicQuery("/cloud_registered")))
      clouds.push_back(*message.instantiate<sensor_msgs::PointCloud2>());
  }
  for (const int k : {1, 2, 3}) append("/rear", clouds.at(static_cast<std::size_t>(k)), k);
  BagInput front, rear;
  front.cloud_topic = "/cloud_registered";
  rear.cloud_topic = "/rear";
  rear.pairing.T_body_sensor.translation().z() = 1;
  std::size_t told = 0;
  rear.progress = [&](std::size_t done, std::size_t of) { told += done <= of && of == 3; };
  LidarsInBag both(file, {front, rear});
  EXPECT_EQ(told, 3u);
  ASSERT_EQ(both.size(), 7u);
  EXPECT_EQ(both.cloud_topics(), (std::vector<std::string>{"/cloud_registered", "/rear"}));
  for (std::size_t i = 1; i < 7; ++i) {
    const int k = static_cast<int>(i + 1) / 2;
    const bool is_rear = i % 2 == 0;
    const Frame frame = both.read(i);
    EXPECT_EQ(frame.name, "00000" + std::to_string(i));
    EXPECT_EQ(frame.scan.stamp_ns, stamp_in_bag_ns(k));
    EXPECT_EQ(frame.scan.sensor, is_rear ? 1 : 0);
    EXPECT_NEAR(frame.T_map_sensor.translation().z(), is_rear ? 3 : 2, 1e-9);
    EXPECT_EQ(both.cloud_of(i).topic, is_rear ? "/rear" : "/cloud_registered");
    EXPECT_EQ(both.cloud_of(i).number, static_cast<std::size_t>(is_rear ? k - 1 : k));
  }
}

}  // namespace
}  // namespace stillmap
