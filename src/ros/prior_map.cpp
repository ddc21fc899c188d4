#include "ros/prior_map.hpp"

#include <ros/console.h>

#include <filesystem>
#include <stdexcept>

#include "io/map_archive.hpp"
#include "io/whole_map.hpp"
#include "maps/change_list.hpp"
#include "messages/map_messages.hpp"

namespace stillmap {
namespace {

/// Says what it did; the mapper is as it was when this throws std::runtime_error.
std::string go_on_with(Mapper& mapper, const MapContents& map, const std::string& path) {
  try {
    mapper.load_map(map);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  return path + ": goes on with its " + std::to_string(mapper.voxel_count()) + " voxels";
}

}  // namespace

PriorMap::PriorMap(ros::NodeHandle private_nh, SharedMapper& shared, const MapDirectory& directory,
                   std::function<std::string()> fixed_frame)
    : shared_(shared), directory_(directory), fixed_frame_(std::move(fixed_frame)) {
  const bool latch = true;
  appeared_ = private_nh.advertise<sensor_msgs::PointCloud2>("appeared", 1, latch);
  gone_ = private_nh.advertise<sensor_msgs::PointCloud2>("gone", 1, latch);
  load_map_ = private_nh.advertiseService("load_map", &PriorMap::on_load_map, this);
  diff_map_ = private_nh.advertiseService("diff_map", &PriorMap::on_diff_map, this);
}

bool PriorMap::on_load_map(LoadMap::Request& request, LoadMap::Response& response) {
  try {
    const std::string path = directory_.file_inside(request.path);
    const MapContents map = read_map_archive(path);
    const std::lock_guard lock(shared_.mutex);
    response.message = go_on_with(shared_.mapper, map, path);
    response.success = true;
  } catch (const std::exception& error) {
    response.message = error.what();
    response.success = false;
  }
  ROS_INFO_STREAM("load_map: " << response.message);
  return true;
}

bool PriorMap::on_diff_map(DiffMap::Request& request, DiffMap::Response& response) {
  try {
    const MapContents earlier = read_map_archive(directory_.file_inside(request.path));
    const MapContents now = contents_of(whole_map(shared_.mapper, shared_.far_tiles.get(), shared_.mutex));
    std::unique_lock lock(shared_.mutex);
    const Decision decision = shared_.mapper.decision();
    lock.unlock();
    const MapDiff found = diff(earlier, now, decision, DiffOptions());
    const auto publish = [&](const ros::Publisher& publisher, const std::vector<Change>& changes) {
      MapSnapshot cloud = snapshot_of(changes, found);
      cloud.stamp_ns = now.stamp_ns;
      publisher.publish(to_static_cloud(cloud, fixed_frame_()));
    };
    publish(appeared_, found.appeared);
    publish(gone_, found.gone);
    response.appeared = static_cast<std::uint32_t>(found.appeared.size());
    response.gone = static_cast<std::uint32_t>(found.gone.size());
    response.message = table_of(found);
    response.success = true;
  } catch (const std::exception& error) {
    response.message = error.what();
    response.success = false;
  }
  ROS_INFO_STREAM("diff_map: " << response.message);
  return true;
}

void resume(Mapper& mapper, const std::string& load_path, const std::string& save_path) {
  if (load_path.empty()) return;
  if (load_path == save_path && !std::filesystem::exists(load_path))
    ROS_INFO_STREAM("load_map: " << load_path << " is not there yet; a new map begins");
  else
    ROS_INFO_STREAM("load_map: " << go_on_with(mapper, read_map_archive(load_path), load_path));
}

}  // namespace stillmap
