#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <stillmap/LabelledMap.h>

#include <boost/shared_ptr.hpp>
#include <string>

#include "messages/octomap_message.hpp"
#include "stillmap/map_snapshot.hpp"

namespace stillmap {

/// Every voxel with its log-odds and label.
LabelledMapPtr to_labelled_map(const MapSnapshot& map, const std::string& frame_id);

/// The centres of the static voxels: x, y, z, intensity = p_static.
sensor_msgs::PointCloud2Ptr to_static_cloud(const MapSnapshot& map, const std::string& frame_id);

/// As to_octree(), in binary form.
boost::shared_ptr<OctomapMessage> to_octomap_message(const MapSnapshot& map, const std::string& frame_id);

}  // namespace stillmap
