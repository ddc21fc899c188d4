// Clouds in the frame of a body that does not stand at the sensor's place: rays begin at the sensor.

#include <gtest/gtest.h>
#include <ros/init.h>
#include <stillmap/LabelledMap.h>

#include <Eigen/Geometry>

#include "messages/make_cloud.hpp"
#include "ros/node_harness.hpp"

namespace stillmap {
namespace {

constexpr double kQuarterTurn = 1.57079632679489661923;

// As body.test says: x y z 1 2 0.5, yaw 90 degrees.
const Eigen::Isometry3d T_body_sensor =
    Eigen::Translation3d(1, 2, 0.5) * Eigen::AngleAxisd(kQuarterTurn, Eigen::Vector3d::UnitZ());

// The room that the sensor sees, in the body's frame.
std::vector<Eigen::Vector3d> room_in_body() {
  std::vector<Eigen::Vector3d> points = room_points();
  for (Eigen::Vector3d& point : points) point = T_body_sensor * point;
  return points;
}

// The body stands at (10, 0, 0) and looks along y.
nav_msgs::Odometry body_odometry(int k) {
  nav_msgs::Odometry odometry = room_odometry(k);
  odometry.pose.pose.position.x = 10;
  odometry.pose.pose.orientation.w = odometry.pose.pose.orientation.z = std::sqrt(0.5);
  return odometry;
}

class Body : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(harness_.wait_for_connections()); }
  const Answer* send(const std::vector<Eigen::Vector3d>& points) {
    ++k_;
    harness_.publish(body_odometry(k_));
    harness_.publish(*make_cloud(points, room_stamp(k_).toNSec()));
    return harness_.answer(room_stamp(k_));
  }
  NodeHarness harness_;
  static int k_;
};
int Body::k_ = 0;

// The map's frame and the sensor's together: the walls are 5 m from the sensor, which is at (8, 1, 0.5).
TEST_F(Body, TheMapIsWhereTheRoomIs) {
  LabelledMapConstPtr map;
  const boost::function<void(const LabelledMapConstPtr&)> keep = [&](const LabelledMapConstPtr& m) {
    map = m;
  };
  const ros::Subscriber subscriber = ros::NodeHandle().subscribe<LabelledMap>("/stillmap/map", 1, keep);
  ASSERT_NE(send(room_in_body()), nullptr);
  ASSERT_TRUE(harness_.wait_until([&] { return map && !map->labels.empty(); }));
  Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9f), high = -low;
  for (std::size_t i = 0; i < map->labels.size(); ++i) {
    const Eigen::Map<const Eigen::Vector3f> center(&map->centers[3 * i]);
    low = low.cwiseMin(center);
    high = high.cwiseMax(center);
  }
  const Eigen::Vector3f room_low(3, -4, -0.5), room_high(13, 6, 2.26f);
  EXPECT_LT((low - room_low).cwiseAbs().maxCoeff(), 0.3f) << low.transpose();
  EXPECT_LT((high - room_high).cwiseAbs().maxCoeff(), 0.3f) << high.transpose();
}

// min_range_m is measured from where the rays begin.
TEST_F(Body, RaysBeginAtTheSensor) {
  std::vector<Eigen::Vector3d> points = room_in_body();
  points.push_back({0.1, 0.1, 0});                                 // at the body's own place
  points.push_back(T_body_sensor.translation());                   // no range
  points.push_back(T_body_sensor * Eigen::Vector3d(0.1, 0.1, 0));  // nearer than min_range_m
  const Answer* answer = send(points);
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->status->invalid_points, 2u);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "body_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
