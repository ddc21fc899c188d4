#include "ros/package_stand_in.hpp"

#include <cstring>

#include "messages/make_cloud.hpp"
#include "messages/pose_message.hpp"
#include "simulation/simulator.hpp"

namespace stillmap {
namespace {

constexpr std::int64_t kFirst_ns = 1'600'000'000'003'700'123;

// From LOAM's axes (x left, y up, z ahead) to ROS's.
const Eigen::Isometry3d& R_ros_loam() {
  static const Eigen::Isometry3d R(
      (Eigen::Matrix3d() << Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX())
          .finished());
  return R;
}

Eigen::Isometry3d T_body_sensor(const PackageConventions& package) {
  return package.sensor_on_body.empty() ? Eigen::Isometry3d::Identity()
                                        : parse_sensor_on_body(package.sensor_on_body);
}

Eigen::Isometry3d T_map_body(const PackageConventions& package, const TrueScan& scan) {
  return scan.T_map_sensor * T_body_sensor(package).inverse();
}

/// From the sensor's frame to that of the message.
Eigen::Isometry3d T_message_sensor(const PackageConventions& package, const TrueScan& scan) {
  if (package.points_in == CloudFrame::kSensor) return Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d T_ros =
      package.points_in == CloudFrame::kWorld ? scan.T_map_sensor : T_body_sensor(package);
  return package.loam_axes ? R_ros_loam().inverse() * T_ros : T_ros;
}

/// Between two scans, where the sensor is taken to go straight.
Eigen::Isometry3d T_map_body_at(const PackageConventions& package, const std::vector<TrueScan>& scans,
                                std::int64_t stamp_ns) {
  std::size_t k = 0;
  while (k + 2 < scans.size() && scans[k + 1].scan.stamp_ns <= stamp_ns) ++k;
  const Eigen::Isometry3d a = T_map_body(package, scans[k]), b = T_map_body(package, scans[k + 1]);
  const double share =
      double(stamp_ns - scans[k].scan.stamp_ns) / double(scans[k + 1].scan.stamp_ns - scans[k].scan.stamp_ns);
  return Eigen::Translation3d(a.translation() + share * (b.translation() - a.translation())) *
         Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear()));
}

nav_msgs::Odometry odometry_at(const PackageConventions& package, std::int64_t stamp_ns,
                               const Eigen::Isometry3d& T_map_body) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp.fromNSec(static_cast<std::uint64_t>(stamp_ns));
  odometry.header.frame_id = package.odom_frame_id;
  odometry.child_frame_id = package.child_frame_id;
  odometry.pose.pose =
      to_message(package.loam_axes ? R_ros_loam().inverse() * T_map_body * R_ros_loam() : T_map_body);
  return odometry;
}

std::int64_t as_stamped(PoseStamps stamps, std::int64_t stamp_ns) {
  if (stamps == PoseStamps::kCutToMicroseconds) return stamp_ns / 1000 * 1000;
  if (stamps == PoseStamps::kMicrosecondLater) return stamp_ns + 1000;
  if (stamps != PoseStamps::kEveryOtherScanAsDouble) return stamp_ns;
  return static_cast<std::int64_t>(ros::Time(double(stamp_ns) * 1e-9).toNSec());
}

sensor_msgs::PointCloud2 cloud_of(const PackageConventions& package, const TrueScan& scan) {
  const Eigen::Isometry3d T = T_message_sensor(package, scan);
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp.fromNSec(static_cast<std::uint64_t>(scan.scan.stamp_ns));
  cloud.header.frame_id = package.cloud_frame_id;
  cloud.fields = {make_field("x", 0, 7), make_field("y", 4, 7), make_field("z", 8, 7)};
  if (package.point_step > 12) cloud.fields.push_back(make_field("intensity", package.point_step - 16, 7));
  cloud.point_step = package.point_step;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(scan.scan.points.size());
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize(cloud.row_step);
  for (std::size_t i = 0; i < scan.scan.points.size(); ++i) {
    const Eigen::Vector3f point = (T * scan.scan.points[i].cast<double>()).cast<float>();
    std::memcpy(&cloud.data[i * cloud.point_step], point.data(), 3 * sizeof(float));
  }
  return cloud;
}

}  // namespace

std::vector<TrueScan> true_scans(std::size_t count) {
  SimulationOptions options;
  options.sensor = "vlp16";
  options.scans = count;
  const Simulator simulator(options);
  std::vector<TrueScan> scans;
  for (std::size_t k = 0; k < count; ++k) {
    SimulatedFrame frame = simulator.frame(k);
    frame.frame.scan.stamp_ns += kFirst_ns;
    scans.push_back({std::move(frame.frame.scan), frame.T_map_sensor_true});
  }
  return scans;
}

std::vector<sensor_msgs::PointCloud2> clouds_of(const PackageConventions& package,
                                                const std::vector<TrueScan>& scans) {
  std::vector<sensor_msgs::PointCloud2> clouds;
  for (const TrueScan& scan : scans) clouds.push_back(cloud_of(package, scan));
  return clouds;
}

std::vector<nav_msgs::Odometry> odometry_of(const PackageConventions& package,
                                            const std::vector<TrueScan>& scans) {
  std::vector<nav_msgs::Odometry> poses;
  const std::int64_t last_ns = scans.back().scan.stamp_ns;
  if (package.stamps == PoseStamps::kHundredPerSecond) {
    constexpr std::int64_t kStep_ns = 10'000'000, kBefore_ns = 4'000'000;
    for (std::int64_t t = scans.front().scan.stamp_ns - kBefore_ns; t < last_ns + kStep_ns; t += kStep_ns)
      poses.push_back(odometry_at(package, t, T_map_body_at(package, scans, t)));
    return poses;
  }
  const std::size_t step = package.stamps == PoseStamps::kEveryOtherScanAsDouble ? 2 : 1;
  for (std::size_t k = 0; k < scans.size(); k += step)
    poses.push_back(odometry_at(package, as_stamped(package.stamps, scans[k].scan.stamp_ns),
                                T_map_body(package, scans[k])));
  return poses;
}

}  // namespace stillmap
