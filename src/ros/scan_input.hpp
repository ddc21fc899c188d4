#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

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
  using Clock = std::chrono::steady_clock;
  /// What comes from one LiDAR.
  struct Lidar {
    std::string topic;
    std::unique_ptr<ScanPairing> pairing;
    ros::Subscriber subscriber;
    Clock::time_point last_taken = Clock::now();
    SilenceWatch silence{last_taken};
  };

  void add_lidar(ros::NodeHandle& nh, const std::string& topic, const PairingOptions& options);
  void on_cloud(Lidar& lidar, const sensor_msgs::PointCloud2ConstPtr& cloud);
  void on_odometry(const nav_msgs::OdometryConstPtr& odometry);
  void on_drop(const std::string& topic, const std::string& reason, const std::string& text);
  void count_without_pose(const std::string& why);
  std::optional<PairedScan> take();
  std::optional<PairedScan> take(Lidar& lidar);
  void warn_when_waiting_long(const Lidar& lidar);
  void warn_of_silence(SilenceWatch& watch, const ros::Subscriber& subscriber, const char* type,
                       const char* parameter);

  const NodeParameters parameters_;
  const std::string own_prefix_;
  ThrottledLog& log_;
  std::unique_ptr<TfPoses> tf_poses_;      ///< with tf2 alone
  std::unique_ptr<AxesFrame> axes_frame_;  ///< where the odometry's z is not up and no fixed_frame is given
  mutable std::mutex mutex_;               ///< of all below
  std::condition_variable arrived_;
  std::vector<std::unique_ptr<Lidar>> lidars_;  ///< by Scan::sensor
  std::string odometry_frame_, cloud_frame_id_, why_no_pose_;
  std::size_t taken_ = 0, without_pose_ = 0;
  std::size_t too_early_ = 0;  ///< clouds from before the first pose, which none will fit
  Clock::time_point start_ = Clock::now();
  SilenceWatch odometry_silence_{start_};
  ros::Subscriber odometry_subscriber_;
};

}  // namespace stillmap
