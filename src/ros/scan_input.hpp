#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "doctor/input_facts.hpp"
#include "messages/scan_pairing.hpp"
#include "ros/axes_frame.hpp"
#include "ros/node_parameters.hpp"
#include "ros/silence_watch.hpp"
#include "ros/tf_poses.hpp"
#include "ros/throttled_log.hpp"

namespace stillmap {

/// The subscriptions. Callbacks only put messages into the queue; a worker takes paired scans out of it.
class ScanInput {
 public:
  /// Topics below `own_prefix` are the node's own outputs.
  ScanInput(ros::NodeHandle nh, const NodeParameters& parameters, const std::string& own_prefix,
            ThrottledLog& log);

  /// The next scan with its pose, waiting for one no longer than `patience`.
  std::optional<PairedScan> next(std::chrono::milliseconds patience);
  /// Once in a while when nothing comes; asks the master what there is.
  void warn_of_silence();
  void close();  ///< takes no more messages; what is queued can still be taken

  std::size_t waiting() const;
  std::map<std::string, std::uint64_t> dropped() const;
  InputFacts facts() const;
  std::string fixed_frame() const;  ///< the map's, without leading slash

 private:
  void on_cloud(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void on_odometry(const nav_msgs::OdometryConstPtr& odometry);
  void on_drop(const std::string& reason, const std::string& text);
  void count_without_pose(const std::string& why);
  std::optional<PairedScan> take();
  void warn_when_waiting_long();
  void warn_of_silence(SilenceWatch& watch, const ros::Subscriber& subscriber, const char* type,
                       const char* parameter);

  using Clock = std::chrono::steady_clock;
  const NodeParameters parameters_;
  const std::string own_prefix_;
  ThrottledLog& log_;
  std::unique_ptr<TfPoses> tf_poses_;      ///< with tf2 alone
  std::unique_ptr<AxesFrame> axes_frame_;  ///< where the odometry's z is not up and no fixed_frame is given
  mutable std::mutex mutex_;               ///< of all below
  std::condition_variable arrived_;
  std::unique_ptr<ScanPairing> pairing_;
  std::string odometry_frame_, cloud_frame_id_, why_no_pose_;
  std::size_t taken_ = 0, without_pose_ = 0;
  std::size_t too_early_ = 0;  ///< clouds from before the first pose, which none will fit
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_taken_ = Clock::now();
  SilenceWatch cloud_silence_{last_taken_}, odometry_silence_{last_taken_};
  ros::Subscriber cloud_subscriber_, odometry_subscriber_;
};

}  // namespace stillmap
