// One fault each: the doctor finds it and names what mends it.

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "doctor/cloud_density.hpp"
#include "doctor/rows.hpp"
#include "doctor/simulated_scans.hpp"

namespace stillmap {
namespace {

const std::vector<PlacedScan>& street() {
  static const std::vector<PlacedScan> scans = simulated("street", "vlp16", 5);
  return scans;
}

PairingOptions told(CloudFrame frame, const std::string& sensor_on_body = "0 0 0 0 0 0",
                    const std::string& axes = "ros") {
  PairingOptions options;
  options.cloud_frame = frame;
  options.T_body_sensor = parse_sensor_on_body(sensor_on_body);
  options.R_ros_odometry = parse_odometry_axes(axes);
  return options;
}

void expect_finding(const std::vector<std::string>& lines, const std::string& check,
                    const std::string& mend) {
  std::string all;
  for (const std::string& line : lines) {
    if (line.rfind(check + ": ", 0) == 0 && line.find(mend) != std::string::npos) return;
    all += line + "\n";
  }
  ADD_FAILURE() << "no " << check << ": ... " << mend << " among:\n" << all;
}

TEST(Doctor, FindsBodyCloudsThatWereCalledWorld) {
  expect_finding(findings(street(), {told(CloudFrame::kSensor)}, told(CloudFrame::kWorld)), "frames",
                 "set cloud_frame to sensor");
  const char imu[] = "0.5 0 0.3 0 0 90";
  expect_finding(findings(street(), {told(CloudFrame::kBody, imu)}, told(CloudFrame::kWorld, imu)), "frames",
                 "set cloud_frame to body");
}

TEST(Doctor, FindsWorldCloudsThatWereCalledBodyOrSensor) {
  for (const CloudFrame said : {CloudFrame::kBody, CloudFrame::kSensor})
    expect_finding(findings(street(), {told(CloudFrame::kWorld)}, told(said)), "frames",
                   "set cloud_frame to world");
}

TEST(Doctor, FindsLoamsAxes) {
  // All of it turned: the ground stands upright.
  expect_finding(
      findings(street(), {told(CloudFrame::kWorld, "0 0 0 0 0 0", "loam")}, told(CloudFrame::kWorld)), "axes",
      "set odometry_axes to loam");
  // The poses alone.
  expect_finding(
      findings(street(), {told(CloudFrame::kSensor, "0 0 0 0 0 0", "loam")}, told(CloudFrame::kSensor)),
      "frames", "odometry_axes to loam");
  // Told so, but not so.
  expect_finding(
      findings(street(), {told(CloudFrame::kWorld)}, told(CloudFrame::kWorld, "0 0 0 0 0 0", "loam")), "axes",
      "set odometry_axes to ros");
}

TEST(Doctor, FindsASensorMountedTurned) {
  expect_finding(findings(street(), {told(CloudFrame::kSensor, "0 0 0 0 0 90")}, told(CloudFrame::kSensor)),
                 "frames", "check the rotation in sensor_on_body");
}

TEST(Doctor, FindsRaysThatStartAtTheImu) {
  expect_finding(findings(street(), {told(CloudFrame::kWorld, "0 0 0.28 0 0 0")}, told(CloudFrame::kWorld)),
                 "origin", " 0.28 0 0 0\"");
  expect_finding(findings(street(), {told(CloudFrame::kBody, "0 0 0.28 0 0 0")}, told(CloudFrame::kBody)),
                 "origin", " 0.28 0 0 0\"");
}

TEST(Doctor, FindsAnOdometryThatStands) {
  Sent sent{told(CloudFrame::kSensor)};
  sent.odometry_stands = true;
  expect_finding(findings(street(), sent, told(CloudFrame::kSensor)), "still", "set odom_topic");
}

TEST(Doctor, FindsRowsWithoutReturnThatWereMoved) {
  std::vector<PlacedScan> scans = street();
  for (PlacedScan& placed : scans)
    for (std::size_t i = 0; i < placed.scan.points.size(); i += 10)
      placed.scan.points[i] = Eigen::Vector3f(0.05F, 0, 0.28F);
  expect_finding(findings(scans, {told(CloudFrame::kWorld)}, told(CloudFrame::kWorld)), "rows",
                 "raise min_range_m above 0.28");
}

TEST(Doctor, FindsScansThatAreEmpty) {
  Scan scan = street().front().scan;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    if (i % 20 != 0) scan.points[i].setConstant(i % 2 == 0 ? 0.0F : std::nanf(""));
  ASSERT_TRUE(check_rows(scan));
  EXPECT_NE(check_rows(scan)->text.find("95 % of the rows are NaN or zero"), std::string::npos)
      << check_rows(scan)->text;
}

/// One point for each voxel, the mean of those in it, as PCL's VoxelGrid.
Scan thinned(const Scan& scan, float leaf_m) {
  std::map<std::array<int, 3>, std::pair<Eigen::Vector3f, int>> cells;
  for (const Eigen::Vector3f& p : scan.points) {
    auto& [sum, n] = cells
                         .try_emplace({int(std::floor(p.x() / leaf_m)), int(std::floor(p.y() / leaf_m)),
                                       int(std::floor(p.z() / leaf_m))},
                                      Eigen::Vector3f(0, 0, 0), 0)
                         .first->second;
    sum += p;
    ++n;
  }
  Scan thin;
  for (const auto& [key, cell] : cells) thin.points.push_back(cell.first / float(cell.second));
  return thin;
}

TEST(Doctor, FindsThinnedClouds) {
  for (const float leaf_m : {0.1F, 0.2F, 0.4F})
    for (const char* sensor : {"vlp16", "os1_64"}) {
      const Scan scan = simulated("street", sensor, 1, 1).front().scan;
      EXPECT_FALSE(check_density(scan)) << sensor;
      EXPECT_TRUE(check_density(thinned(scan, leaf_m))) << sensor << ", " << leaf_m;
    }
}

TEST(Doctor, FindsAnOutcomeThatCannotBe) {
  Doctor doctor(told(CloudFrame::kSensor));
  std::vector<Finding> found;
  LabelCounts counts;
  counts.dynamic = counts.is_static = 500;
  for (std::size_t k = 0; k < Doctor::kScans; ++k)
    for (const Finding& finding : doctor.add({}, Eigen::Isometry3d::Identity(), counts))
      found.push_back(finding);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().check, "outcome");
  EXPECT_NE(found.front().text.find("50 % of the returns"), std::string::npos);
}

}  // namespace
}  // namespace stillmap
