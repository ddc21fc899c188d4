#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <stillmap/Status.h>

#include <chrono>
#include <cstdint>
#include <vector>

#include "doctor/finding.hpp"

namespace stillmap {

/// /diagnostics, once a second of wall time: the clock of a recording may stand still.
class NodeDiagnostics {
 public:
  NodeDiagnostics(ros::NodeHandle nh, ros::NodeHandle private_nh);
  void update_if_due(const Status& status, const std::vector<Finding>& findings, std::size_t scans_examined);

 private:
  void fill(diagnostic_updater::DiagnosticStatusWrapper& out);
  void fill_setup(diagnostic_updater::DiagnosticStatusWrapper& out);

  using Clock = std::chrono::steady_clock;
  diagnostic_updater::Updater updater_;
  Clock::time_point last_;
  Status status_;
  std::vector<Finding> findings_;
  std::size_t scans_examined_ = 0;
  std::uint64_t scans_before_ = 0, dropped_before_ = 0;
};

}  // namespace stillmap
