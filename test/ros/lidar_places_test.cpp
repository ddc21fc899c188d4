#include "ros/lidar_places.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace stillmap {
namespace {

NodeParameters with(const std::string& topics, const std::string& places) {
  NodeParameters parameters;
  parameters.cloud_topic = topics;
  parameters.sensor_on_body = places;
  return parameters;
}

TEST(LidarPlaces, OneForEachTopic) {
  const auto lidars = lidar_places(with("/front  /rear", "1 0 0.3 0 0 0; -1 0 0.3 0 0 180"));
  ASSERT_EQ(lidars.size(), 2u);
  EXPECT_EQ(lidars[0].topic, "/front");
  EXPECT_EQ(lidars[1].topic, "/rear");
  EXPECT_EQ(lidars[0].T_body_sensor.translation().x(), 1);
  EXPECT_NEAR((lidars[1].T_body_sensor * Eigen::Vector3d::UnitX()).x(), -2, 1e-12);
}

TEST(LidarPlaces, WithTfAloneNoPlaceIsNeeded) {
  NodeParameters parameters = with("/front /rear", "0 0 0 0 0 0");
  parameters.odom_topic = "";
  EXPECT_EQ(lidar_places(parameters).size(), 2u);
}

TEST(LidarPlaces, RefusesWhatDoesNotFit) {
  const auto refused = [](const std::string& topics, const std::string& places,
                          std::initializer_list<std::string> words) {
    expect_error<std::invalid_argument>([&] { lidar_places(with(topics, places)); }, words);
  };
  refused("", "0 0 0 0 0 0", {"cloud_topic: empty"});
  refused("/a /b", "0 0 0 0 0 0", {"sensor_on_body: 1 places for 2 topics", "; between"});
  refused("/a", "0 0 0 0 0 0; 1 0 0 0 0 0", {"2 places for 1 topics"});
  refused("/a /a", "0 0 0 0 0 0; 1 0 0 0 0 0", {"/a is named twice"});
  refused("/a /b", "0 0 0 0 0 0; here", {"sensor_on_body: ' here'"});
}

}  // namespace
}  // namespace stillmap
