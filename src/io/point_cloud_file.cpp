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

/// PCL refuses to write clouds without points; a map may have no static voxel yet.
std::string empty_file(bool ply) {
  if (ply)
    return "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
           "property float intensity\nend_header\n";
  return "VERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 0\nHEIGHT 1\n"
         "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 0\nDATA ascii\n";
}

int write_cloud(const pcl::PointCloud<pcl::PointXYZI>& cloud, bool ply, const std::string& file) {
  const bool binary = true, camera = false;
  return ply ? pcl::PLYWriter().write<pcl::PointXYZI>(file, cloud, binary, camera)
             : pcl::PCDWriter().writeBinary(file, cloud);
}

}  // namespace

void save_point_cloud(const MapSnapshot& map, const std::string& path) {
  const pcl::PointCloud<pcl::PointXYZI> cloud = static_points(map);
  const bool ply = std::filesystem::path(path).extension() == ".ply";
  if (cloud.empty()) return write_text_atomically(path, empty_file(ply));
  write_atomically(path, [&](const std::string& file) {
    try {
      if (write_cloud(cloud, ply, file) == 0) return;
    } catch (const pcl::IOException& error) {
      throw std::runtime_error(path + ": cannot be written: " + error.what());
    }
    throw std::runtime_error(path + ": cannot be written; is the disk full?");
  });
}

}  // namespace stillmap
