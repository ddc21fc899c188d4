#include "io/point_cloud_file.hpp"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "io/atomic_file.hpp"

namespace stillmap {
namespace {

pcl::PointCloud<pcl::PointXYZI> static_points(const MapSnapshot& map) {
  pcl::PointCloud<pcl::PointXYZI> cloud;
  for (const SnapshotVoxel& voxel : map.voxels) {
    if (voxel.label != Label::kStatic) continue;
    const float p_static = 1.0F / (1.0F + std::exp(-voxel.log_odds));
    pcl::PointXYZI point;
    point.getVector3fMap() = voxel.center;
    point.intensity = p_static;
    cloud.push_back(point);
  }
  return cloud;
}

void write_ply(const pcl::PointCloud<pcl::PointXYZI>& cloud, const std::string& file) {
  if (pcl::PLYWriter().write<pcl::PointXYZI>(file, cloud, true, false) != 0)
    throw std::runtime_error("PLY writer failed");
}

void write_pcd(const pcl::PointCloud<pcl::PointXYZI>& cloud, const std::string& file) {
  // PCL refuses clouds without points; a map may have no static voxel yet.
  if (pcl::PCDWriter().writeBinary(file, cloud) != 0) throw std::runtime_error("PCD writer failed");
}

}  // namespace

void save_point_cloud(const MapSnapshot& map, const std::string& path) {
  const pcl::PointCloud<pcl::PointXYZI> cloud = static_points(map);
  const bool ply = std::filesystem::path(path).extension() == ".ply";
  write_atomically(path, [&](const std::string& file) {
    try {
      ply ? write_ply(cloud, file) : write_pcd(cloud, file);
    } catch (const pcl::IOException& error) {
      throw std::runtime_error(path + ": cannot be written: " + error.what());
    }
  });
}

}  // namespace stillmap
