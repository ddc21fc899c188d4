#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>
#include <stillmap/SaveMap.h>

#include <memory>
#include <mutex>
#include <string>

#include "stillmap/mapper.hpp"

namespace stillmap {

/// The mapper, for the worker and the services: whoever uses it holds the mutex.
struct SharedMapper {
  std::mutex mutex;
  std::unique_ptr<TileStore> far_tiles;  ///< nullptr = none are kept; needs no mutex
  Mapper mapper;
};

/// ~save_map and ~reset, on a thread of their own: writing a file holds up neither callbacks nor scans.
class MapServices {
 public:
  MapServices(ros::NodeHandle private_nh, SharedMapper& shared);
  ~MapServices() { spinner_.stop(); }

  /// Saves the map when scans have come since it was last saved; reports on the console.
  void save_if_changed(const std::string& path);

 private:
  std::string save(const std::string& path);  ///< says what was saved; throws std::runtime_error
  bool on_save_map(SaveMap::Request& request, SaveMap::Response& response);
  bool on_reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  SharedMapper& shared_;
  std::mutex file_mutex_;  ///< one file at a time
  std::size_t saved_scan_count_ = 0;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  ros::ServiceServer save_map_, reset_;
};

}  // namespace stillmap
