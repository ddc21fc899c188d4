// Each preset beside a stand-in that publishes as its package does: rays start where the sensor was, and the
// labels are those of the core that is told so.

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/init.h>
#include <tf2_msgs/TFMessage.h>

#include <map>

#include "messages/point_cloud_conversion.hpp"
#include "ros/node_harness.hpp"
#include "ros/odometry_presets.hpp"
#include "ros/package_stand_in.hpp"
#include "ros/stillmap_ros.hpp"

namespace stillmap {
namespace {

// Given, not found: the last digits of what is found are the rounding's, and all pixels hang on them.
constexpr double kRingSpacing_deg = 2.0, kAzimuthStep_deg = 0.2;
constexpr std::size_t kScans = 11;  // odd: the last one is a keyframe, too
const std::vector<TrueScan>& scans() {
  static const std::vector<TrueScan> all = true_scans(kScans);
  return all;
}

/// What the core says when it is told the true poses; the same for every package.
const std::vector<ScanLabels>& true_labels() {
  static const std::vector<ScanLabels> all = [] {
    std::vector<ScanLabels> labels;
    Parameters parameters;
    parameters.ring_spacing_deg = kRingSpacing_deg;
    parameters.azimuth_step_deg = kAzimuthStep_deg;
    Mapper mapper(parameters);
    for (const TrueScan& scan : scans()) labels.push_back(mapper.process(scan.scan, scan.T_map_sensor));
    return labels;
  }();
  return all;
}

class Presets : public testing::TestWithParam<PackageConventions> {
 protected:
  void SetUp() override {
    const PackageConventions& package = GetParam();
    private_nh_.setParam("odometry_preset", package.preset);
    private_nh_.setParam("ring_spacing_deg", kRingSpacing_deg);
    private_nh_.setParam("azimuth_step_deg", kAzimuthStep_deg);
    if (!package.sensor_on_body.empty()) private_nh_.setParam("sensor_on_body", package.sensor_on_body);
    node_ = std::make_unique<StillmapRos>(nh_, private_nh_);
    cloud_publisher_ = nh_.advertise<sensor_msgs::PointCloud2>(package.cloud_topic, 100);
    odometry_publisher_ = nh_.advertise<nav_msgs::Odometry>(package.odom_topic, 1000);
    const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> keep_labels =
        [this](const sensor_msgs::PointCloud2ConstPtr& cloud) { labelled_[cloud->header.stamp] = cloud; };
    const boost::function<void(const nav_msgs::OdometryConstPtr&)> keep_origin =
        [this](const nav_msgs::OdometryConstPtr& origin) { origins_[origin->header.stamp] = origin; };
    labelled_subscriber_ =
        private_nh_.subscribe<sensor_msgs::PointCloud2>("labelled_points", 100, keep_labels);
    origin_subscriber_ = private_nh_.subscribe<nav_msgs::Odometry>("sensor_odometry", 100, keep_origin);
    ASSERT_TRUE(NodeHarness::wait_until([this] {
      return cloud_publisher_.getNumSubscribers() > 0 && odometry_publisher_.getNumSubscribers() > 0 &&
             labelled_subscriber_.getNumPublishers() > 0 && origin_subscriber_.getNumPublishers() > 0;
    }));
  }

  /// The clouds one by one, all poses before: the order of arrival has tests of its own.
  void send_all(const PackageConventions& package) {
    for (const nav_msgs::Odometry& pose : odometry_of(package, scans())) odometry_publisher_.publish(pose);
    for (const sensor_msgs::PointCloud2& cloud : clouds_of(package, scans())) {
      cloud_publisher_.publish(cloud);
      const ros::Time stamp = cloud.header.stamp;
      ASSERT_TRUE(NodeHarness::wait_until([&] { return labelled_.count(stamp) && origins_.count(stamp); }));
    }
  }

  void expect_origins() {
    const std::string frame =
        GetParam().odom_frame_id.substr(GetParam().odom_frame_id.find_first_not_of('/'));
    const bool between_keyframes = GetParam().stamps == PoseStamps::kEveryOtherScanAsDouble;
    for (const TrueScan& scan : scans()) {
      const nav_msgs::Odometry& seen = *origins_.at(ros::Time().fromNSec(scan.scan.stamp_ns));
      const Eigen::Isometry3d error = scan.T_map_sensor.inverse() * to_pose(seen);
      EXPECT_LT(error.translation().norm(), 0.005);
      EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), between_keyframes ? 0.004 : 0.001);
      EXPECT_EQ(seen.header.frame_id, GetParam().loam_axes ? frame + "_z_up" : frame);
    }
  }

  /// Rounding at a voxel's border may turn a row or two; poses that are interpolated are not quite the true
  /// ones.
  void expect_labels() {
    std::size_t rows = 0, same = 0, dynamic = 0;
    for (std::size_t k = 0; k < kScans; ++k) {
      const sensor_msgs::PointCloud2& cloud = *labelled_.at(ros::Time().fromNSec(scans()[k].scan.stamp_ns));
      const std::uint32_t label_at = (cloud.fields.end() - 2)->offset;
      ASSERT_EQ(row_count(cloud), true_labels()[k].label.size());
      for (std::size_t i = 0; i < row_count(cloud); ++i) {
        const auto expected = static_cast<std::uint8_t>(true_labels()[k].label[i]);
        same += row_data(cloud, i)[label_at] == expected;
        dynamic += expected == static_cast<std::uint8_t>(Label::kDynamic);
        ++rows;
      }
    }
    std::printf("%s: %.3f %% of %zu rows as the core says\n", GetParam().preset.c_str(),
                100.0 * double(same) / double(rows), rows);
    const bool between_keyframes = GetParam().stamps == PoseStamps::kEveryOtherScanAsDouble;
    EXPECT_GT(double(same), (between_keyframes ? 0.99 : 0.999) * double(rows));
    EXPECT_GT(dynamic, 100u) << "the street must have something to find";
  }

  ros::NodeHandle nh_, private_nh_{"/stillmap_" + GetParam().preset};
  std::unique_ptr<StillmapRos> node_;
  ros::Publisher cloud_publisher_, odometry_publisher_;
  ros::Subscriber labelled_subscriber_, origin_subscriber_;
  std::map<ros::Time, sensor_msgs::PointCloud2ConstPtr> labelled_;
  std::map<ros::Time, nav_msgs::OdometryConstPtr> origins_;
};

TEST_P(Presets, RaysStartAtTheSensorAndTheLabelsAreTheCores) {
  ASSERT_NO_FATAL_FAILURE(send_all(GetParam()));
  expect_origins();
  expect_labels();
}

// The map has z up, whatever the odometry's axes: the static transform leads from one to the other.
TEST_P(Presets, TurnedAxesHaveATransform) {
  if (!GetParam().loam_axes) return;
  tf2_msgs::TFMessageConstPtr transforms;
  const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> keep =
      [&](const tf2_msgs::TFMessageConstPtr& message) { transforms = message; };
  const ros::Subscriber subscriber = nh_.subscribe<tf2_msgs::TFMessage>("/tf_static", 10, keep);
  odometry_publisher_.publish(odometry_of(GetParam(), scans()).front());
  ASSERT_TRUE(NodeHarness::wait_until([&] { return transforms != nullptr; }));
  const geometry_msgs::TransformStamped& transform = transforms->transforms.at(0);
  EXPECT_EQ(transform.header.frame_id, "camera_init");
  EXPECT_EQ(transform.child_frame_id, "camera_init_z_up");
  const geometry_msgs::Quaternion& q = transform.transform.rotation;
  const Eigen::Vector3d up = Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d ahead = Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Eigen::Vector3d::UnitX();
  EXPECT_TRUE(up.isApprox(Eigen::Vector3d::UnitY(), 1e-9)) << up.transpose();
  EXPECT_TRUE(ahead.isApprox(Eigen::Vector3d::UnitZ(), 1e-9)) << ahead.transpose();
}

// Registered clouds under a preset that takes the sensor's: /diagnostics says which parameter mends it.
TEST_P(Presets, TheDoctorTellsOfAnotherFrame) {
  if (GetParam().preset != "kiss_icp") return;
  std::string said;
  const boost::function<void(const diagnostic_msgs::DiagnosticArrayConstPtr&)> keep =
      [&](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
        for (const diagnostic_msgs::DiagnosticStatus& status : array->status)
          if (status.name == "stillmap_kiss_icp: setup" &&
              status.level == diagnostic_msgs::DiagnosticStatus::WARN)
            said = status.message;
      };
  const ros::Subscriber subscriber =
      nh_.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10, keep);
  PackageConventions registered = GetParam();
  registered.points_in = CloudFrame::kWorld;
  ASSERT_NO_FATAL_FAILURE(send_all(registered));
  EXPECT_TRUE(NodeHarness::wait_until([&] { return !said.empty(); }));
  EXPECT_EQ(said.rfind("frames: read as cloud_frame sensor", 0), 0u) << said;
  EXPECT_NE(said.find("set cloud_frame to world"), std::string::npos) << said;
}

INSTANTIATE_TEST_SUITE_P(All, Presets, testing::ValuesIn(known_packages()),
                         [](const auto& info) { return info.param.preset; });

TEST(PresetFiles, EachHasItsStandIn) {
  std::vector<std::string> files, tested;
  for (const OdometryPreset& preset : odometry_presets()) files.push_back(preset.name);
  for (const PackageConventions& package : known_packages()) tested.push_back(package.preset);
  std::sort(tested.begin(), tested.end());
  EXPECT_EQ(files, tested);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "presets_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
