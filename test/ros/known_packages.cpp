#include "ros/package_stand_in.hpp"

namespace stillmap {
namespace {

constexpr char kImu[] = "0.05 -0.02 0.28 1 -2 3";
const CloudFrame kWorld = CloudFrame::kWorld, kBody = CloudFrame::kBody, kSensor = CloudFrame::kSensor;

}  // namespace

const std::vector<PackageConventions>& known_packages() {
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

}  // namespace stillmap
