#include "messages/pairing_options.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace stillmap {
namespace {

constexpr double kUnitTolerance = 0.01;  // rounded to two decimals is still a rotation

std::vector<double> parse_numbers(std::string text) {
  for (char& c : text)
    if (c == ',' || c == '[' || c == ']') c = ' ';
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (double number; stream >> number;) numbers.push_back(number);
  if (!stream.eof()) numbers.clear();  // a word that is no number
  return numbers;
}

Eigen::Quaterniond from_roll_pitch_yaw_deg(double roll_deg, double pitch_deg, double yaw_deg) {
  constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
  return Eigen::AngleAxisd(yaw_deg * kRadPerDeg, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch_deg * kRadPerDeg, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll_deg * kRadPerDeg, Eigen::Vector3d::UnitX());
}

}  // namespace

CloudFrame parse_cloud_frame(const std::string& text) {
  if (text == "world") return CloudFrame::kWorld;
  if (text == "body") return CloudFrame::kBody;
  if (text == "sensor") return CloudFrame::kSensor;
  throw std::invalid_argument("cloud_frame: '" + text + "' is not one of world|body|sensor");
}

Eigen::Matrix3d parse_odometry_axes(const std::string& text) {
  if (text == "ros") return Eigen::Matrix3d::Identity();
  if (text != "loam") throw std::invalid_argument("odometry_axes: '" + text + "' is not one of ros|loam");
  Eigen::Matrix3d R_ros_loam;
  R_ros_loam << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return R_ros_loam;
}

Eigen::Isometry3d parse_sensor_on_body(const std::string& text) {
  const std::vector<double> n = parse_numbers(text);
  if (n.size() != 6 && n.size() != 7)
    throw std::invalid_argument("sensor_on_body: '" + text +
                                "' is not 'x y z roll_deg pitch_deg yaw_deg' or 'x y z qx qy qz qw'");
  const Eigen::Quaterniond rotation =
      n.size() == 6 ? from_roll_pitch_yaw_deg(n[3], n[4], n[5]) : Eigen::Quaterniond(n[6], n[3], n[4], n[5]);
  try {
    return checked_pose({n[0], n[1], n[2]}, rotation);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("sensor_on_body: " + std::string(error.what()));
  }
}

Eigen::Isometry3d checked_pose(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation) {
  std::ostringstream seen;
  seen << "position (" << translation.transpose() << "), quaternion xyzw (" << rotation.coeffs().transpose()
       << ")";
  if (!translation.allFinite() || !rotation.coeffs().allFinite())
    throw std::invalid_argument("a number of the pose is not finite: " + seen.str());
  if (std::abs(rotation.norm() - 1.0) > kUnitTolerance)
    throw std::invalid_argument("the quaternion has length " + std::to_string(rotation.norm()) +
                                ", not 1: " + seen.str());
  return Eigen::Translation3d(translation) * rotation.normalized();
}

}  // namespace stillmap
