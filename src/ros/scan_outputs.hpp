#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <stillmap/Status.h>

#include <string>

#include "messages/scan_pairing.hpp"
#include "stillmap/delayed_labels.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// What is published for every scan, each only when somebody listens.
class ScanOutputs {
 public:
  /// `resolved_delay` in scans; 0 = no ~resolved.
  ScanOutputs(ros::NodeHandle private_nh, int resolved_delay);
  /// The scan at its own time.
  void publish(const PairedScan& paired, const ScanLabels& labels);
  /// After mapper.process() of the scan, whose labels these are: the one that is now resolved.
  void publish_resolved(const Mapper& mapper, const PairedScan& paired, const ScanLabels& labels);
  /// When no scan follows: the resolved ones that still wait.
  void publish_waiting(const Mapper& mapper);
  void publish(const Status& status);
  /// Where the rays of the scan start.
  void publish(const std_msgs::Header& header, const Eigen::Isometry3d& T_map_sensor,
               const std::string& map_frame);

 private:
  using Delayed = DelayedLabels<PairedScan>;
  void publish_resolved(const Delayed::Settled& settled);

  ros::Publisher static_, dynamic_, uncertain_, labelled_, sensor_odometry_, resolved_, status_;
  Delayed delayed_;
};

}  // namespace stillmap
