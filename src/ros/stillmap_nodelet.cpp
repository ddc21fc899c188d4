#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>
#include <stdexcept>

#include "ros/stillmap_ros.hpp"

namespace stillmap {

/// Loaded by a nodelet manager; see StillmapRos.
class StillmapNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      inside_ = std::make_unique<StillmapRos>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const std::exception& error) {  // the manager's other nodelets must go on
      NODELET_FATAL_STREAM("not started: " << error.what());
    }
  }

  std::unique_ptr<StillmapRos> inside_;
};

}  // namespace stillmap

PLUGINLIB_EXPORT_CLASS(stillmap::StillmapNodelet, nodelet::Nodelet)
