#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>
#include <stillmap/SaveMap.h>

#include <memory>
#include <mutex>
#include <string>

#include "ros/map_directory.hpp"
#include "ros/shared_mapper.hpp"

namespace stillmap {

/// ~save_map, into files in the directory, and ~reset.
class MapServices {
 public:
  MapServices(ros::NodeHandle private_nh, SharedMapper& shared, const MapDirectory& directory);

  /// Saves the map when scans have come since it was last saved; reports on the console.
  void save_if_changed(const std::string& path);

 private:
  std::string save(const std::string& path);  ///< says what was saved; throws std::runtime_error
  bool on_save_map(SaveMap::Request& request, SaveMap::Response& response);
  bool on_reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  SharedMapper& shared_;
  const MapDirectory directory_;
  std::mutex file_mutex_;  ///< one file at a time
  std::uint64_t saved_revision_ = 0;
  ros::ServiceServer save_map_, reset_;
};

}  // namespace stillmap
