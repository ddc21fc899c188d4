#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "messages/pairing_options.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// A scan as it was: its points in the sensor's frame, and where the sensor was, z up.
struct TrueScan {
  Scan scan;
  Eigen::Isometry3d T_map_sensor;
};
/// Of a simulated street, ten in a second.
std::vector<TrueScan> true_scans(std::size_t count);

/// When an odometry package gives its poses.
enum class PoseStamps {
  kOfTheScans,
  kCutToMicroseconds,
  kMicrosecondLater,
  kHundredPerSecond,       ///< none of them the scans'
  kEveryOtherScanAsDouble  ///< keyframes; the stamp went through a double
};

/// What a package publishes, beside the numbers.
struct PackageConventions {
  std::string preset;
  std::string cloud_topic, cloud_frame_id;
  std::string odom_topic, odom_frame_id, child_frame_id;
  CloudFrame points_in;
  bool loam_axes = false;           ///< of the odometry's frames, and of points_in world and body
  std::string sensor_on_body = {};  ///< empty = the body is the sensor
  PoseStamps stamps = PoseStamps::kOfTheScans;
  std::uint32_t point_step = 32;  ///< 12: xyz alone; 32, 48: PCL's PointXYZI, PointXYZINormal
};

/// One for each preset, as the package's sources have it.
const std::vector<PackageConventions>& known_packages();

/// The messages that the package would send of the scans.
std::vector<sensor_msgs::PointCloud2> clouds_of(const PackageConventions& package,
                                                const std::vector<TrueScan>& scans);
std::vector<nav_msgs::Odometry> odometry_of(const PackageConventions& package,
                                            const std::vector<TrueScan>& scans);

}  // namespace stillmap
