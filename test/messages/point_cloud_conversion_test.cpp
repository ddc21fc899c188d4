#include "messages/point_cloud_conversion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "messages/expect_message.hpp"
#include "messages/make_cloud.hpp"

namespace stillmap {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const std::vector<Eigen::Vector3d> kPoints = {{1.5, -2.25, 3.0}, {kNaN, 0, 1}, {0, 0, 0}, {100.125, 7, -8}};

void expect_points(const sensor_msgs::PointCloud2& cloud) {
  Scan scan;
  to_scan(cloud, scan);
  ASSERT_EQ(scan.points.size(), kPoints.size());
  for (std::size_t i = 0; i < kPoints.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isnan(kPoints[i][axis]))
        EXPECT_TRUE(std::isnan(scan.points[i][axis])) << i;
      else
        EXPECT_EQ(scan.points[i][axis], static_cast<float>(kPoints[i][axis])) << i;
    }
}

void expect_refused(const sensor_msgs::PointCloud2& cloud, const std::string& words) {
  Scan scan;
  expect_message<std::runtime_error>([&] { to_scan(cloud, scan); }, words);
}

TEST(PointCloudConversion, KeepsEveryRowAndTheStamp) {
  const auto cloud = make_cloud(kPoints, 1'600'000'000'123'456'789);
  expect_points(*cloud);
  Scan scan;
  to_scan(*cloud, scan);
  EXPECT_EQ(scan.stamp_ns, 1'600'000'000'123'456'789);
}

TEST(PointCloudConversion, ReadsFloat64) {
  expect_points(*make_cloud<double>(kPoints));
}

TEST(PointCloudConversion, ReadsBigEndianOfBothSizes) {
  const auto single = make_cloud<float>(kPoints);
  make_bigendian(*single);
  expect_points(*single);
  const auto twice = make_cloud<double>(kPoints);
  make_bigendian(*twice);
  expect_points(*twice);
}

TEST(PointCloudConversion, SkipsThePaddingOfImageLikeRows) {
  const auto cloud = make_cloud(kPoints);
  cloud->height = 2;
  cloud->width = 2;
  cloud->row_step = 2 * cloud->point_step + 6;
  cloud->data.insert(cloud->data.begin() + 2 * cloud->point_step, 6, 0xFF);
  expect_points(*cloud);
}

TEST(PointCloudConversion, AnEmptyCloudIsAnEmptyScan) {
  Scan scan;
  scan.points.resize(3);
  to_scan(sensor_msgs::PointCloud2(), scan);
  EXPECT_TRUE(scan.points.empty());
}

TEST(PointCloudConversion, RefusesACloudWithoutCoordinates) {
  const auto cloud = make_cloud(kPoints);
  cloud->fields[1].name = "range";
  expect_refused(*cloud, "no field 'y' (fields: x, range, z, ring)");
}

TEST(PointCloudConversion, RefusesIntegerCoordinates) {
  const auto cloud = make_cloud(kPoints);
  cloud->fields[2].datatype = sensor_msgs::PointField::INT16;
  expect_refused(*cloud, "field 'z' has datatype 3");
}

TEST(PointCloudConversion, RefusesAFieldBeyondThePoint) {
  const auto cloud = make_cloud(kPoints);
  cloud->fields[0].offset = cloud->point_step - 2;
  expect_refused(*cloud, "field 'x' at offset 15 reaches past point_step 17");
}

TEST(PointCloudConversion, RefusesTooFewBytes) {
  const auto cloud = make_cloud(kPoints);
  cloud->data.pop_back();
  expect_refused(*cloud, "data holds 67 bytes but 4 x 1 points need 68");
}

TEST(PointCloudConversion, RefusesAShortRowStep) {
  const auto cloud = make_cloud(kPoints);
  cloud->width = 2;
  cloud->height = 2;
  cloud->row_step = 20;
  expect_refused(*cloud, "row_step is 20");
}

}  // namespace
}  // namespace stillmap
