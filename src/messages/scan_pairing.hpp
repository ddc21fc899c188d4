#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "messages/pairing_options.hpp"
#include "messages/pose_buffer.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// A cloud with its place, ready for the mapper.
struct PairedScan {
  sensor_msgs::PointCloud2ConstPtr cloud;
  Scan scan;  ///< in the sensor frame
  Eigen::Isometry3d T_map_sensor = Eigen::Isometry3d::Identity();
  std::chrono::steady_clock::time_point arrived;  ///< the cloud, as ScanPairing was told
};

/// The cloud's points brought into the sensor frame, in double precision. Throws as to_scan() does.
PairedScan to_paired_scan(const sensor_msgs::PointCloud2ConstPtr& cloud, const Eigen::Isometry3d& T_map_body,
                          const PairingOptions& options);

/// The pose of an odometry message; throws std::invalid_argument as checked_pose() does.
Eigen::Isometry3d to_pose(const nav_msgs::Odometry& odometry);

/// Brings clouds and poses together by stamp, in the order of the clouds' stamps, whatever the order of
/// arrival.
class ScanPairing {
 public:
  /// A step back that is longer is a new beginning (a bag that loops, an odometry that restarts), a shorter
  /// one is a message out of order.
  static constexpr std::int64_t kRestart_ns = 1'000'000'000;

  /// Poses come from add_odometry().
  explicit ScanPairing(const PairingOptions& options);
  /// Poses come from `poses`, which outlives this.
  ScanPairing(const PairingOptions& options, const PoseSource& poses);
  ScanPairing(const ScanPairing&) = delete;
  ScanPairing& operator=(const ScanPairing&) = delete;

  void add_cloud(const sensor_msgs::PointCloud2ConstPtr& cloud,
                 std::chrono::steady_clock::time_point arrived = {});
  /// Throws std::invalid_argument on a pose that is not finite or not of unit length; it then is not used.
  void add_odometry(const nav_msgs::Odometry& odometry);

  /// The oldest cloud whose pose is known; none when its pose may still come. Throws std::runtime_error on a
  /// cloud that cannot be read, which is dropped.
  std::optional<PairedScan> next();

  std::size_t waiting() const { return clouds_.size(); }
  std::optional<std::int64_t> oldest_stamp_ns() const {
    return clouds_.empty() ? std::nullopt : std::make_optional(clouds_.begin()->first);
  }
  std::string waiting_for() const;  ///< why the oldest cloud waits; empty when none does

  /// Clouds that will never be answered, by reason: queue_full, no_pose, late, jumped_back, too_large,
  /// unreadable.
  const std::map<std::string, std::uint64_t>& dropped() const { return dropped_; }
  /// Called with the reason and one sentence whenever clouds are dropped or the stamps jump back.
  using DropListener = std::function<void(const std::string& reason, const std::string& text)>;
  void set_drop_listener(DropListener listener) { listener_ = std::move(listener); }

 private:
  struct Waiting {
    sensor_msgs::PointCloud2ConstPtr cloud;
    std::chrono::steady_clock::time_point arrived;
  };
  using Clouds = std::map<std::int64_t, Waiting>;
  void drop(const std::string& reason, const std::string& text, std::size_t clouds = 1);
  void restart(const std::string& text);
  void make_room();
  PoseAnswer pose_of(Clouds::const_iterator cloud) const;

  PairingOptions options_;
  PoseBuffer odometry_;
  const PoseSource& poses_;
  Clouds clouds_;
  std::optional<std::int64_t> newest_cloud_ns_, last_taken_ns_;
  std::map<std::string, std::uint64_t> dropped_;
  DropListener listener_;
};

}  // namespace stillmap
