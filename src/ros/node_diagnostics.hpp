#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <stillmap/Status.h>

#include <chrono>
#include <cstdint>

namespace stillmap {

/// /diagnostics, once a second of wall time: the clock of a recording may stand still.
class NodeDiagnostics {
 public:
  NodeDiagnostics(ros::NodeHandle nh, ros::NodeHandle private_nh);
  void update_if_due(const Status& status);

 private:
  void fill(diagnostic_updater::DiagnosticStatusWrapper& out);

  using Clock = std::chrono::steady_clock;
  diagnostic_updater::Updater updater_;
  Clock::time_point last_;
  Status status_;
  std::uint64_t scans_before_ = 0, dropped_before_ = 0;
};

}  // namespace stillmap
