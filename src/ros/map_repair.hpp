#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <stillmap/ClearBox.h>
#include <stillmap/RelabelBox.h>

#include "ros/shared_mapper.hpp"

namespace stillmap {

/// ~clear_box and ~relabel_box: repair of the map by hand.
class MapRepair {
 public:
  MapRepair(ros::NodeHandle private_nh, SharedMapper& shared);

 private:
  bool on_clear_box(ClearBox::Request& request, ClearBox::Response& response);
  bool on_relabel_box(RelabelBox::Request& request, RelabelBox::Response& response);

  SharedMapper& shared_;
  ros::ServiceServer clear_box_, relabel_box_;
};

}  // namespace stillmap
