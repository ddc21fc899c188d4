#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "messages/scan_pairing.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {

/// ~moving_boxes: a box around each thing that moves; computed only when somebody listens.
class MovingBoxOutput {
 public:
  MovingBoxOutput(ros::NodeHandle private_nh, double lifetime_s);
  /// After mapper.process() of the scan.
  void publish(const Mapper& mapper, const PairedScan& paired, const std::string& fixed_frame);

 private:
  double lifetime_s_;
  ros::Publisher publisher_;
};

}  // namespace stillmap
