#pragma once

#include <gtest/gtest.h>
#include <ros/service.h>
#include <std_srvs/Trigger.h>
#include <stillmap/ExplainPoint.h>

#include "ros/node_harness.hpp"

namespace stillmap {

inline geometry_msgs::Point point(double x, double y, double z) {
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

/// Every test begins with the map of eight scans of a room whose walls are 5 m away.
class MapTools : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(harness().wait_for_connections());
    std_srvs::Trigger reset;
    ASSERT_TRUE(ros::service::call("/stillmap/reset", reset));
    for (int k = 0; k < 8; ++k) ASSERT_TRUE(scan());
  }
  static void SetUpTestSuite() { harness_ = new NodeHarness; }
  static void TearDownTestSuite() { delete harness_; }
  static NodeHarness& harness() { return *harness_; }
  bool scan() {
    harness().publish(room_odometry(newest_));
    harness().publish(*room_cloud(newest_));
    return harness().answer(room_odometry(newest_++).header.stamp) != nullptr;
  }
  template <class Service>
  static typename Service::Response call(const std::string& name, const typename Service::Request& request) {
    Service service;
    service.request = request;
    EXPECT_TRUE(ros::service::call("/stillmap/" + name, service));
    return service.response;
  }
  template <class Service>
  static typename Service::Response call_with_path(const std::string& name, const std::string& path) {
    typename Service::Request request;
    request.path = path;
    return call<Service>(name, request);
  }
  static ExplainPoint::Response explain(const geometry_msgs::Point& place) {
    ExplainPoint::Request request;
    request.point = place;
    return call<ExplainPoint>("explain_point", request);
  }
  template <class Box>
  static typename Box::Request wall_box(double x = 4.5) {
    typename Box::Request request;
    request.min = point(x, -1, -0.5);
    request.max = point(x + 1, 1, 0.5);
    return request;
  }
  template <class Message>
  static boost::shared_ptr<const Message> latched(const std::string& topic) {
    boost::shared_ptr<const Message> message;
    const boost::function<void(const boost::shared_ptr<const Message>&)> keep =
        [&](const boost::shared_ptr<const Message>& received) { message = received; };
    const ros::Subscriber subscriber = ros::NodeHandle().subscribe<Message>(topic, 1, keep);
    harness().wait_until([&] { return message != nullptr; });
    return message;
  }
  inline static NodeHarness* harness_ = nullptr;
  inline static int newest_ = 0;
};

}  // namespace stillmap
