#include "ros/stillmap_ros.hpp"

#include <ros/console.h>

#include <stdexcept>

#include "io/tile_folder.hpp"
#include "stillmap/worker_threads.hpp"

namespace stillmap {
namespace {

constexpr std::chrono::milliseconds kPatience(100);

void warn(const std::string& message) {
  ROS_WARN_STREAM(message);
}

double milliseconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

std::size_t judged(const LabelCounts& counts) {
  return counts.uncertain + counts.is_static + counts.dynamic;
}

}  // namespace

StillmapRos::StillmapRos(ros::NodeHandle nh, ros::NodeHandle private_nh)
    : settings_(load_settings(private_nh)),
      shared_{{}, open_tile_folder(settings_.method, warn), Mapper(settings_.method)},
      outputs_(private_nh, settings_.node.resolved_delay),
      moving_boxes_(private_nh, settings_.node.box_lifetime_s),
      map_outputs_(private_nh, settings_.node.map_period_s),
      service_thread_(private_nh),
      services_(service_thread_.handle(), shared_, MapDirectory(settings_.node.map_directory)),
      live_parameters_(private_nh, settings_),
      repair_(service_thread_.handle(), shared_),
      diagnostics_(nh, private_nh),
      doctor_(check_node_parameters(settings_.node)),
      input_(nh, settings_.node, private_nh.getNamespace() + "/", log_),
      explainer_(nh, service_thread_.handle(), shared_, [this] { return input_.fixed_frame(); }),
      prior_map_(service_thread_.handle(), shared_, MapDirectory(settings_.node.map_directory),
                 [this] { return input_.fixed_frame(); }),
      corrections_(nh, settings_.node, log_) {
  const std::string too_many_threads = threads_message(settings_.method);
  if (!too_many_threads.empty()) ROS_WARN_STREAM("stillmap: " << too_many_threads);
  shared_.mapper.set_listener(&stage_timer_);
  shared_.mapper.set_tile_store(shared_.far_tiles.get());
  resume(shared_.mapper, settings_.node.load_map, settings_.node.save_map);
  for (int i = 0; i < kStageCount; ++i) status_.stages.push_back(to_string(static_cast<Stage>(i)));
  const NodeParameters& node = settings_.node;
  ROS_INFO_STREAM("stillmap: preset " << node.odometry_preset << ": " << node.cloud_topic << " ("
                                      << node.cloud_frame << ") with "
                                      << (node.odom_topic.empty() ? "tf2" : node.odom_topic));
  worker_ = std::thread(&StillmapRos::work, this);
}

StillmapRos::~StillmapRos() {
  input_.close();
  closing_ = true;
  worker_.join();
  if (!settings_.node.save_map.empty()) services_.save_if_changed(settings_.node.save_map);
}

void StillmapRos::work() {
  for (;;) {
    const bool is_last_call = closing_;
    const std::optional<PairedScan> paired =
        input_.next(is_last_call ? std::chrono::milliseconds(0) : kPatience);
    update_live_parameters();
    if (paired) process(*paired);
    if (!paired && is_last_call) return;
    between_scans();
  }
}

void StillmapRos::process(const PairedScan& paired) {
  last_scan_ = Clock::now();
  try {
    const std::lock_guard lock(shared_.mutex);  // the labels are valid until the next process()
    begin_anew_after_jump(paired.scan);
    corrections_.apply(shared_.mapper, paired.scan.stamp_ns, input_.fixed_frame());
    stage_timer_.start();
    const ScanLabels& labels = shared_.mapper.label(paired.scan, paired.T_map_sensor);
    status_.label_ms = stage_timer_.total_ms();
    outputs_.publish(paired, labels);
    status_.latency_ms = milliseconds(Clock::now() - paired.arrived);
    outputs_.publish(paired.cloud->header, paired.T_map_sensor, input_.fixed_frame());
    moving_boxes_.publish(shared_.mapper, paired, input_.fixed_frame());
    stage_timer_.go_on();
    shared_.mapper.upkeep();
    status_.process_ms = stage_timer_.total_ms();
    outputs_.publish_resolved(shared_.mapper, paired, labels);
    report(paired, labels);
    doctor_.look_at(paired, labels);
  } catch (const std::exception& error) {  // the worker must outlive a scan that it cannot take
    log_.warn("process", settings_.node.cloud_topic + ": a scan is left out: " + error.what());
  }
}

/// A recording that loops, an odometry that starts again: the map is of another time.
void StillmapRos::begin_anew_after_jump(const Scan& scan) {
  const auto [last, is_first] = last_stamp_ns_.try_emplace(scan.sensor, scan.stamp_ns);
  const bool has_jumped = !is_first && scan.stamp_ns < last->second - ScanPairing::kRestart_ns;
  last->second = scan.stamp_ns;
  if (!has_jumped || settings_.node.after_jump_back != "new_map") return;
  shared_.mapper.reset();
  last_stamp_ns_ = {{scan.sensor, scan.stamp_ns}};  // those of other LiDARs are still from before
}

void StillmapRos::report(const PairedScan& paired, const ScanLabels& labels) {
  const LabelCounts counts = count(labels);
  if (labels.label.empty())
    log_.warn("empty", settings_.node.cloud_topic +
                           ": a scan has no rows; the map stays as it is. Check the sensor's driver");
  else if (judged(counts) == 0)
    log_.warn("unusable", settings_.node.cloud_topic + ": a scan of " + std::to_string(labels.label.size()) +
                              " rows has no usable return (all NaN, zero or nearer than min_range_m); the "
                              "map stays as it is. Check the sensor's driver");
  status_.header = paired.cloud->header;
  status_.static_points = static_cast<std::uint32_t>(counts.is_static);
  status_.dynamic_points = static_cast<std::uint32_t>(counts.dynamic);
  status_.uncertain_points = static_cast<std::uint32_t>(counts.uncertain);
  status_.invalid_points = static_cast<std::uint32_t>(counts.invalid);
  status_.scans = shared_.mapper.scan_count();
  status_.voxels = shared_.mapper.voxel_count();
  status_.stage_ms.assign(stage_timer_.stage_ms.begin(), stage_timer_.stage_ms.end());
  outputs_.publish(status_);
}

void StillmapRos::update_live_parameters() {
  if (!live_parameters_.update(settings_)) return;
  map_outputs_.set_period(settings_.node.map_period_s);
  const std::lock_guard lock(shared_.mutex);
  shared_.mapper.set_decision(settings_.method.p_static_min, settings_.method.p_dynamic_max);
}

void StillmapRos::between_scans() {
  input_.warn_of_silence();
  status_.waiting = static_cast<std::uint32_t>(input_.waiting());
  status_.drop_reasons.clear();
  status_.dropped.clear();
  for (const auto& [reason, scans] : input_.dropped()) {
    status_.drop_reasons.push_back(reason);
    status_.dropped.push_back(scans);
  }
  doctor_.look_at(input_.facts());
  diagnostics_.update_if_due(status_, doctor_.findings(), doctor_.scans());
  {
    const std::lock_guard lock(shared_.mutex);
    map_outputs_.publish_if_due(shared_.mapper, input_.fixed_frame());
  }
  const bool is_idle =
      Clock::now() - last_scan_ > std::chrono::duration<double>(settings_.node.save_map_idle_s);
  if (!is_idle) return;
  {
    const std::lock_guard lock(shared_.mutex);
    outputs_.publish_waiting(shared_.mapper);
  }
  if (!settings_.node.save_map.empty()) services_.save_if_changed(settings_.node.save_map);
}

}  // namespace stillmap
