#include "ros/map_services.hpp"

#include <ros/console.h>

#include <stdexcept>

#include "io/map_file.hpp"
#include "io/whole_map.hpp"
#include "stillmap/log_odds.hpp"

namespace stillmap {
namespace {

std::size_t count_static(const std::vector<BlockContents>& blocks, const Decision& decision) {
  std::size_t count = 0;
  for (const BlockContents& block : blocks)
    for (const Voxel& voxel : block.voxels)
      count += decision(p_from_log_odds(voxel.log_odds())) == Label::kStatic;
  return count;
}

}  // namespace

MapServices::MapServices(ros::NodeHandle private_nh, SharedMapper& shared, const MapDirectory& directory)
    : shared_(shared), directory_(directory) {
  save_map_ = private_nh.advertiseService("save_map", &MapServices::on_save_map, this);
  reset_ = private_nh.advertiseService("reset", &MapServices::on_reset, this);
}

std::string MapServices::save(const std::string& path) {
  std::unique_lock lock(shared_.mutex);
  const std::size_t scan_count = shared_.mapper.scan_count();
  const Decision decision = shared_.mapper.decision();
  lock.unlock();
  const std::lock_guard file_lock(file_mutex_);
  MapPieces map = whole_map(shared_.mapper, shared_.far_tiles.get(), shared_.mutex);
  std::size_t static_voxels = 0;
  map.next = [&, next = std::move(map.next)](std::vector<BlockContents>& blocks) {
    const bool is_piece = next(blocks);
    if (is_piece) static_voxels += count_static(blocks, decision);
    if (!is_piece && static_voxels == 0)
      throw std::runtime_error(path + ": not written, the map has no static voxel after " +
                               std::to_string(scan_count) + " scans");
    return is_piece;
  };
  save_map(map, decision, path);
  return path + ": map of " + std::to_string(static_voxels) + " static voxels after " +
         std::to_string(scan_count) + " scans";
}

void MapServices::save_if_changed(const std::string& path) {
  std::unique_lock lock(shared_.mutex);
  const std::uint64_t revision = shared_.mapper.revision();
  if (revision == saved_revision_ || shared_.mapper.voxel_count() == 0) return;
  saved_revision_ = revision;
  lock.unlock();
  try {
    ROS_INFO_STREAM("saved " << save(path));
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("save_map: " << error.what());
  }
}

bool MapServices::on_save_map(SaveMap::Request& request, SaveMap::Response& response) {
  try {
    response.message = "saved " + save(directory_.new_file_inside(request.path, request.overwrite));
    response.success = true;
  } catch (const std::exception& error) {
    response.message = error.what();
    response.success = false;
  }
  ROS_INFO_STREAM("save_map: " << response.message);
  return true;
}

bool MapServices::on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const std::lock_guard lock(shared_.mutex);
  response.message = "forgot the map of " + std::to_string(shared_.mapper.scan_count()) + " scans";
  shared_.mapper.reset();
  response.success = true;
  ROS_INFO_STREAM("reset: " << response.message);
  return true;
}

}  // namespace stillmap
