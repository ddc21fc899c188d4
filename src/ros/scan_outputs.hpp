#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <stillmap/Status.h>

#include "messages/scan_pairing.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// What is published for every scan, each only when somebody listens.
class ScanOutputs {
 public:
  explicit ScanOutputs(ros::NodeHandle private_nh);
  void publish(const sensor_msgs::PointCloud2& cloud, const ScanLabels& labels);
  void publish(const Status& status);

 private:
  ros::Publisher static_, dynamic_, uncertain_, labelled_, status_;
};

}  // namespace stillmap
