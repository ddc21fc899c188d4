#include "messages/scan_pairing.hpp"

#include <stdexcept>

#include "messages/point_cloud_conversion.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kOdometryKept = 10'000;

std::string seconds(std::int64_t ns) {
  return std::to_string(double(ns) * 1e-9) + " s";
}

// Rows of zeros mean "no return" in every frame, so they stay zeros.
void transform(const Eigen::Isometry3d& T, Scan& scan) {
  const Eigen::Matrix3d R = T.linear();
  const Eigen::Vector3d t = T.translation();
  for (Eigen::Vector3f& point : scan.points)
    if (!point.isZero(0)) point = (R * point.cast<double>() + t).cast<float>();
}

}  // namespace

PairedScan to_paired_scan(const sensor_msgs::PointCloud2ConstPtr& cloud, const Eigen::Isometry3d& T_map_body,
                          const PairingOptions& options) {
  PairedScan paired;
  paired.cloud = cloud;
  const Eigen::Isometry3d R(options.R_ros_odometry);
  paired.T_map_sensor = R * T_map_body * R.inverse() * options.T_body_sensor;
  to_scan(*cloud, paired.scan);
  if (options.cloud_frame == CloudFrame::kWorld) transform(paired.T_map_sensor.inverse() * R, paired.scan);
  if (options.cloud_frame == CloudFrame::kBody) transform(options.T_body_sensor.inverse() * R, paired.scan);
  return paired;
}

Eigen::Isometry3d to_pose(const nav_msgs::Odometry& odometry) {
  const auto& p = odometry.pose.pose.position;
  const auto& q = odometry.pose.pose.orientation;
  return checked_pose({p.x, p.y, p.z}, {q.w, q.x, q.y, q.z});
}

ScanPairing::ScanPairing(const PairingOptions& options)
    : options_(options), odometry_(options.max_gap_s, kOdometryKept), poses_(odometry_) {}

ScanPairing::ScanPairing(const PairingOptions& options, const PoseSource& poses)
    : options_(options), odometry_(options.max_gap_s, kOdometryKept), poses_(poses) {}

void ScanPairing::add_cloud(const sensor_msgs::PointCloud2ConstPtr& cloud,
                            std::chrono::steady_clock::time_point arrived) {
  if (cloud->data.size() > options_.max_cloud_bytes) {
    drop("too_large", "it has " + std::to_string(cloud->data.size()) + " bytes");
    return;
  }
  const auto stamp_ns = static_cast<std::int64_t>(cloud->header.stamp.toNSec());
  if (newest_cloud_ns_ && stamp_ns < *newest_cloud_ns_ - kRestart_ns) {
    restart("the stamps jumped back by " + seconds(*newest_cloud_ns_ - stamp_ns));
    // Its pose may come after it: poses from before the jump must not answer for it.
    if (!odometry_.empty() && odometry_.newest_stamp_ns() > stamp_ns + kRestart_ns) odometry_.clear();
  }
  if ((last_taken_ns_ && stamp_ns <= *last_taken_ns_) || clouds_.count(stamp_ns)) {
    drop("late", "its stamp is not after the one before");
    return;
  }
  newest_cloud_ns_ = std::max(newest_cloud_ns_.value_or(stamp_ns), stamp_ns);
  clouds_[stamp_ns] = {cloud, arrived};
  make_room();
}

void ScanPairing::add_odometry(const nav_msgs::Odometry& odometry) {
  const Eigen::Isometry3d T_map_body = to_pose(odometry);
  const auto stamp_ns = static_cast<std::int64_t>(odometry.header.stamp.toNSec());
  if (!odometry_.empty() && stamp_ns < odometry_.newest_stamp_ns() - kRestart_ns) odometry_.clear();
  odometry_.add(stamp_ns, T_map_body);
}

std::optional<PairedScan> ScanPairing::next() {
  while (!clouds_.empty()) {
    const auto oldest = clouds_.begin();
    const PoseAnswer answer = pose_of(oldest);
    if (answer.kind == PoseAnswer::Kind::kWait) return std::nullopt;
    const Waiting waiting = oldest->second;
    last_taken_ns_ = oldest->first;
    clouds_.erase(oldest);
    if (answer.kind == PoseAnswer::Kind::kNever) {
      drop("no_pose", answer.why);
      continue;
    }
    try {
      PairedScan paired = to_paired_scan(waiting.cloud, answer.T_map_body, options_);
      paired.arrived = waiting.arrived;
      return paired;
    } catch (const std::runtime_error& error) {
      drop("unreadable", error.what());
      throw;
    }
  }
  return std::nullopt;
}

std::string ScanPairing::waiting_for() const {
  return clouds_.empty() ? "" : pose_of(clouds_.begin()).why;
}

PoseAnswer ScanPairing::pose_of(Clouds::const_iterator cloud) const {
  return poses_.at(cloud->first, cloud->second.cloud->header.frame_id);
}

void ScanPairing::make_room() {
  while (clouds_.size() > options_.queue_size) {
    const PoseAnswer answer = pose_of(clouds_.begin());
    clouds_.erase(clouds_.begin());
    if (answer.kind == PoseAnswer::Kind::kFound)
      drop("queue_full", "scans come faster than they are worked off");
    else
      drop("no_pose", answer.why);
  }
}

void ScanPairing::restart(const std::string& text) {
  drop("jumped_back", text, clouds_.size());
  clouds_.clear();
  newest_cloud_ns_ = last_taken_ns_ = std::nullopt;
}

void ScanPairing::drop(const std::string& reason, const std::string& text, std::size_t clouds) {
  dropped_[reason] += clouds;
  if (listener_) listener_(reason, text);
}

}  // namespace stillmap
