#include "messages/pairing_options.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "messages/expect_message.hpp"

namespace stillmap {
namespace {

void expect_refused(const std::string& text, const std::string& words) {
  expect_message<std::invalid_argument>([&] { parse_sensor_on_body(text); }, words);
}

TEST(SensorOnBody, TakesAnglesInDegrees) {
  const Eigen::Isometry3d T = parse_sensor_on_body("1 2 3 0 0 90");
  EXPECT_TRUE((T * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(1, 3, 3)));
}

TEST(SensorOnBody, AppliesRollThenPitchThenYaw) {
  const Eigen::Isometry3d T = parse_sensor_on_body("0 0 0 90 0 90");
  EXPECT_TRUE((T * Eigen::Vector3d(0, 1, 0)).isApprox(Eigen::Vector3d(0, 0, 1)));
  EXPECT_TRUE((T * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(0, 1, 0)));
}

TEST(SensorOnBody, TakesAQuaternionAndAYamlList) {
  const Eigen::Isometry3d T = parse_sensor_on_body("[1, 2, 3, 0, 0, 0.70710678, 0.70710678]");
  EXPECT_TRUE(T.isApprox(parse_sensor_on_body("1 2 3 0 0 90"), 1e-7));
}

TEST(SensorOnBody, RefusesWhatIsNoPlace) {
  expect_refused("1 2 3", "sensor_on_body: '1 2 3' is not");
  expect_refused("1 2 3 a b c", "sensor_on_body");
  expect_refused("", "sensor_on_body");
  expect_refused("0 0 0 0 0 0 0", "length 0.000000, not 1");
}

TEST(CloudFrame, RefusesAnUnknownName) {
  EXPECT_EQ(parse_cloud_frame("body"), CloudFrame::kBody);
  expect_message<std::invalid_argument>([] { parse_cloud_frame("lidar"); },
                                        "cloud_frame: 'lidar' is not one of world|body|sensor");
}

TEST(CheckedPose, RefusesNumbersThatAreNotFiniteOrNotUnit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Quaterniond identity = Eigen::Quaterniond::Identity();
  const auto refused = [](const Eigen::Vector3d& t, const Eigen::Quaterniond& q, const std::string& words) {
    expect_message<std::invalid_argument>([&] { checked_pose(t, q); }, words);
  };
  refused({nan, 0, 0}, identity, "not finite");
  refused({0, 0, 0}, {nan, 0, 0, 1}, "not finite");
  refused({0, 0, 0}, {0, 0, 0, 0}, "length 0.000000, not 1");
  refused({0, 0, 0}, {2, 0, 0, 0}, "length 2.000000, not 1");
}

}  // namespace
}  // namespace stillmap
