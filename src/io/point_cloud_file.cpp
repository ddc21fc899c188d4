#include "io/point_cloud_file.hpp"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "io/atomic_file.hpp"
#include "io/little_endian.hpp"

namespace stillmap {
namespace {

pcl::PointCloud<pcl::PointXYZI> static_points(const MapSnapshot& map) {
  pcl::PointCloud<pcl::PointXYZI> cloud;
  cloud.reserve(map.voxels.size());
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
constexpr char kEmptyPcd[] =
    "VERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 0\nHEIGHT 1\n"
    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 0\nDATA ascii\n";

/// PCL's writer of .ply does not see that the disk is full.
std::string ply_file(const pcl::PointCloud<pcl::PointXYZI>& cloud) {
  std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(cloud.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nproperty float intensity\n"
                     "end_header\n";
  LittleEndianWriter out(file);
  for (const pcl::PointXYZI& point : cloud)
    for (const float value : {point.x, point.y, point.z, point.intensity}) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      out.put(bits);
    }
  return file;
}

}  // namespace

void save_point_cloud(const MapSnapshot& map, const std::string& path) {
  const pcl::PointCloud<pcl::PointXYZI> cloud = static_points(map);
  if (std::filesystem::path(path).extension() == ".ply") return write_text_atomically(path, ply_file(cloud));
  if (cloud.empty()) return write_text_atomically(path, kEmptyPcd);
  write_atomically(path, [&](const std::string& file) {
    try {
      if (pcl::PCDWriter().writeBinary(file, cloud) == 0) return;
    } catch (const pcl::IOException& error) {
      throw std::runtime_error(path + ": cannot be written: " + error.what());
    }
    throw std::runtime_error(path + ": cannot be written; is the disk full?");
  });
}

}  // namespace stillmap
