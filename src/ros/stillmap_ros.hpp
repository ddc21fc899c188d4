#pragma once

#include <ros/node_handle.h>
#include <stillmap/Status.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <thread>

#include "ros/live_parameters.hpp"
#include "ros/map_outputs.hpp"
#include "ros/map_repair.hpp"
#include "ros/map_services.hpp"
#include "ros/moving_box_output.hpp"
#include "ros/node_diagnostics.hpp"
#include "ros/node_doctor.hpp"
#include "ros/parameter_server.hpp"
#include "ros/place_explainer.hpp"
#include "ros/prior_map.hpp"
#include "ros/scan_input.hpp"
#include "ros/scan_outputs.hpp"
#include "ros/service_thread.hpp"
#include "ros/stage_timer.hpp"
#include "ros/throttled_log.hpp"
#include "ros/trajectory_corrections.hpp"

namespace stillmap {

/// The inside of the nodelet and of the node: scans in, labelled scans and maps out. One worker thread does
/// all work, so that the subscribers' callbacks never wait.
class StillmapRos {
 public:
  /// Throws std::runtime_error when a parameter is refused.
  StillmapRos(ros::NodeHandle nh, ros::NodeHandle private_nh);
  /// Finishes the queue and saves the map.
  ~StillmapRos();

 private:
  void work();
  void process(const PairedScan& paired);
  void begin_anew_after_jump(const Scan& scan);
  void report(const PairedScan& paired, const ScanLabels& labels);
  void between_scans();
  void update_live_parameters();

  using Clock = std::chrono::steady_clock;
  NodeSettings settings_;  ///< the live ones change
  ThrottledLog log_;
  SharedMapper shared_;
  StageTimer stage_timer_;
  ScanOutputs outputs_;
  MovingBoxOutput moving_boxes_;
  MapOutputs map_outputs_;
  ServiceThread service_thread_;
  MapServices services_;
  LiveParameters live_parameters_;
  MapRepair repair_;
  NodeDiagnostics diagnostics_;
  NodeDoctor doctor_;
  Status status_;
  std::map<int, std::int64_t> last_stamp_ns_;  ///< of each LiDAR
  Clock::time_point last_scan_ = Clock::now();
  ScanInput input_;
  PlaceExplainer explainer_;
  PriorMap prior_map_;
  TrajectoryCorrections corrections_;
  std::atomic<bool> closing_{false};
  std::thread worker_;  ///< last: starts when all else is there
};

}  // namespace stillmap
