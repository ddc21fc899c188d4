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

constexpr std::size_t kScans = 11;  // odd: the last one is a keyframe, too
constexpr char kImu[] = "0.05 -0.02 0.28 1 -2 3";
const CloudFrame kWorld = CloudFrame::kWorld, kBody = CloudFrame::kBody, kSensor = CloudFrame::kSensor;

const std::vector<PackageConventions>& packages() {
  static const std::vector<PackageConventions> all = {
      {"aloam", "/velodyne_cloud_registered", "/camera_init", "/aft_mapped_to_init", "/camera_init",
       "/aft_mapped", kWorld},
      {"loam", "/velodyne_cloud_registered", "/camera_init", "/aft_mapped_to_init", "/camera_init",
       "/aft_mapped", kWorld, true},
      {"lego_loam", "/velodyne_points", "velodyne", "/integrated_to_init", "/camera_init", "/camera", kSensor,
       true},
      {"lio_sam", "/lio_sam/mapping/cloud_registered_raw", "odom", "/lio_sam/mapping/odometry", "odom",
       "odom_mapping", kWorld},
      {"fast_lio", "/cloud_registered", "camera_init", "/Odometry", "camera_init", "body", kWorld, false,
       kImu, PoseStamps::kOfTheScans, 48},
      {"point_lio", "/cloud_registered_body", "body", "/aft_mapped_to_init", "camera_init", "body", kBody,
       false, kImu, PoseStamps::kOfTheScans, 48},
      {"dlio", "/robot/dlio/odom_node/pointcloud/deskewed", "odom", "/robot/dlio/odom_node/odom", "odom",
       "base_link", kWorld, false, "0.2 0 0.4 0 0 90", PoseStamps::kHundredPerSecond},
      {"kiss_icp", "/kiss/frame", "velodyne", "/kiss/odometry", "odom", "", kSensor, false, "",
       PoseStamps::kOfTheScans, 12},
      {"hdl_graph_slam", "/filtered_points", "base_link", "/odom", "odom", "base_link", kBody, false,
       "0 0 1.2 0 5 0", PoseStamps::kCutToMicroseconds},
      {"glim", "/glim_ros/points", "imu", "/glim_ros/odom", "odom", "imu", kBody, false, kImu,
       PoseStamps::kMicrosecondLater},
      {"sc_pgo", "/velodyne_cloud_registered_local", "/camera_init", "/aft_pgo_odom", "/camera_init",
       "/aft_pgo", kSensor, false, "", PoseStamps::kEveryOtherScanAsDouble},
      {"generic", "/cloud_registered", "map", "/Odometry", "map", "base_link", kWorld, false, kImu},
  };
  return all;
}

const std::vector<TrueScan>& scans() {
  static const std::vector<TrueScan> all = true_scans(kScans);
  return all;
}

/// What the core says when it is told the true poses; the same for every package.
const std::vector<ScanLabels>& true_labels() {
  static const std::vector<ScanLabels> all = [] {
    std::vector<ScanLabels> labels;
    Mapper mapper{Parameters{}};
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

INSTANTIATE_TEST_SUITE_P(All, Presets, testing::ValuesIn(packages()),
                         [](const auto& info) { return info.param.preset; });

std::string output_of(const std::string& command) {
  FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = pipe ? std::fgetc(pipe) : EOF; c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  EXPECT_EQ(pipe ? pclose(pipe) : -1, 0) << command;
  return text;
}
std::string parameters_of_launch(const std::string& arguments) {
  return output_of("roslaunch --dump-params stillmap stillmap.launch " + arguments);
}

TEST(LaunchFile, GivesTheNodeWhatIsNamedOnly) {
  const std::string preset_alone = parameters_of_launch("preset:=dlio");
  EXPECT_NE(preset_alone.find("/stillmap/odometry_preset: dlio"), std::string::npos) << preset_alone;
  EXPECT_EQ(preset_alone.find("_topic"), std::string::npos) << preset_alone;
  EXPECT_EQ(preset_alone.find("cloud_frame"), std::string::npos) << preset_alone;
  EXPECT_EQ(preset_alone.find("sensor_on_body"), std::string::npos) << preset_alone;
  const std::string named =
      parameters_of_launch("preset:=dlio cloud_topic:=/x odom_topic:=tf2 cloud_frame:=sensor");
  EXPECT_NE(named.find("/stillmap/cloud_topic: /x"), std::string::npos) << named;
  EXPECT_NE(named.find("/stillmap/odom_topic: ''"), std::string::npos) << named;
  EXPECT_NE(named.find("/stillmap/cloud_frame: sensor"), std::string::npos) << named;
}

TEST(LaunchFile, ShowsTheMapsFrameInRviz) {
  std::string presets, frames;
  for (const PackageConventions& package : packages()) {
    if (package.preset == "generic") continue;  // any frame
    presets += " " + package.preset;
    frames += package.odom_frame_id.substr(package.odom_frame_id.find_first_not_of('/')) +
              (package.loam_axes ? "_z_up" : "") + "\n";
  }
  const std::string print_frames =
      "import sys, roslaunch.config, roslaunch.xmlloader as loader\n"
      "for preset in sys.argv[2:]:\n"
      "  config = roslaunch.config.ROSLaunchConfig()\n"
      "  loader.XmlLoader().load(sys.argv[1], config, argv=['preset:=' + preset, 'rviz:=true'], "
      "verbose=False)\n"
      "  print([node.args.split(' -f ')[1] for node in config.nodes if node.name == 'rviz'][0])\n";
  EXPECT_EQ(output_of("/usr/bin/python3 -c \"" + print_frames +
                      "\" $(rospack find stillmap)/launch/stillmap.launch" + presets),
            frames);
}

TEST(PresetFiles, EachHasItsStandIn) {
  std::vector<std::string> files, tested;
  for (const OdometryPreset& preset : odometry_presets()) files.push_back(preset.name);
  for (const PackageConventions& package : packages()) tested.push_back(package.preset);
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
