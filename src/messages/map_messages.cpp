#include "messages/map_messages.hpp"

#include <octomap/OcTree.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <sstream>

#include "io/octomap_file.hpp"

namespace stillmap {
namespace {

std_msgs::Header header_of(const MapSnapshot& map, const std::string& frame_id) {
  std_msgs::Header header;
  header.stamp.fromNSec(static_cast<std::uint64_t>(map.stamp_ns));
  header.frame_id = frame_id;
  return header;
}

// Eq. (1): the probability that belongs to log-odds L.
float probability(float log_odds) {
  return 1.0f / (1.0f + std::exp(-log_odds));
}

}  // namespace

LabelledMapPtr to_labelled_map(const MapSnapshot& map, const std::string& frame_id) {
  auto message = boost::make_shared<LabelledMap>();
  message->header = header_of(map, frame_id);
  message->voxel_size_m = map.voxel_size_m;
  message->centers.resize(3 * map.voxels.size());
  message->log_odds.resize(map.voxels.size());
  message->labels.resize(map.voxels.size());
  for (std::size_t i = 0; i < map.voxels.size(); ++i) {
    const SnapshotVoxel& voxel = map.voxels[i];
    for (std::size_t axis = 0; axis < 3; ++axis) message->centers[3 * i + axis] = voxel.center[axis];
    message->log_odds[i] = voxel.log_odds;
    message->labels[i] = static_cast<std::uint8_t>(voxel.label);
  }
  return message;
}

sensor_msgs::PointCloud2Ptr to_static_cloud(const MapSnapshot& map, const std::string& frame_id) {
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header = header_of(map, frame_id);
  cloud->is_dense = true;
  const auto is_static = [](const SnapshotVoxel& voxel) { return voxel.label == Label::kStatic; };
  const auto size = std::count_if(map.voxels.begin(), map.voxels.end(), is_static);
  sensor_msgs::PointCloud2Modifier modifier(*cloud);
  using sensor_msgs::PointField;
  modifier.setPointCloud2Fields(4, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                PointField::FLOAT32, "intensity", 1, PointField::FLOAT32);
  modifier.resize(static_cast<std::size_t>(size));
  if (size == 0) return cloud;
  sensor_msgs::PointCloud2Iterator<float> to(*cloud, "x");
  for (const SnapshotVoxel& voxel : map.voxels) {
    if (!is_static(voxel)) continue;
    for (int axis = 0; axis < 3; ++axis) to[axis] = voxel.center[axis];
    to[3] = probability(voxel.log_odds);
    ++to;
  }
  return cloud;
}

boost::shared_ptr<OctomapMessage> to_octomap_message(const MapSnapshot& map, const std::string& frame_id) {
  auto message = boost::make_shared<OctomapMessage>();
  message->header = header_of(map, frame_id);
  message->id = "OcTree";
  message->resolution = map.voxel_size_m;
  std::ostringstream stream;
  to_octree(map)->writeBinaryData(stream);
  const std::string bytes = stream.str();
  message->data.assign(bytes.begin(), bytes.end());
  return message;
}

}  // namespace stillmap
