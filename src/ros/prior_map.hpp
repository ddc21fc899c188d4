#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <stillmap/DiffMap.h>
#include <stillmap/LoadMap.h>

#include <functional>
#include <string>

#include "ros/map_directory.hpp"
#include "ros/shared_mapper.hpp"

namespace stillmap {

/// Maps of earlier sessions: ~load_map goes on with one, ~diff_map shows on ~appeared and ~gone what is
/// different now.
class PriorMap {
 public:
  /// Files lie in `directory`; `fixed_frame` says the map's frame.
  PriorMap(ros::NodeHandle private_nh, SharedMapper& shared, const MapDirectory& directory,
           std::function<std::string()> fixed_frame);

 private:
  bool on_load_map(LoadMap::Request& request, LoadMap::Response& response);
  bool on_diff_map(DiffMap::Request& request, DiffMap::Response& response);

  SharedMapper& shared_;
  const MapDirectory directory_;
  std::function<std::string()> fixed_frame_;
  ros::Publisher appeared_, gone_;
  ros::ServiceServer load_map_, diff_map_;
};

/// At the start: goes on with a saved map. One that is to be saved under the same name may not be there yet.
void resume(Mapper& mapper, const std::string& load_path, const std::string& save_path);

}  // namespace stillmap
