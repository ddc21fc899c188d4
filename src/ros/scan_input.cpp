#include "ros/scan_input.hpp"

#include <algorithm>
#include <stdexcept>

#include "messages/frame_id.hpp"
#include "ros/lidar_places.hpp"

namespace stillmap {
namespace {

constexpr int kCloudsInTransit = 100, kOdometryInTransit = 2000;
constexpr std::chrono::seconds kLongWait(2);

std::string advice(const std::string& reason, const NodeParameters& parameters) {
  if (reason == "queue_full") return "; give more threads, a larger voxel_size_m or queue_size";
  if (reason == "no_pose") return "; check odom_topic, fixed_frame and the stamps of both";
  if (reason == "late") return "; the publisher must give each scan its own, growing stamp";
  if (reason == "too_large") return "; it is more than max_cloud_mb";
  if (reason == "jumped_back")
    return parameters.after_jump_back == "new_map"
               ? "; the map begins anew"
               : "; the map is kept: call ~reset to begin anew, or set after_jump_back to new_map";
  return "";
}

}  // namespace

ScanInput::ScanInput(ros::NodeHandle nh, const NodeParameters& parameters, const std::string& own_prefix,
                     ThrottledLog& log)
    : parameters_(parameters), own_prefix_(own_prefix), log_(log) {
  PairingOptions options = check_node_parameters(parameters);
  if (parameters.odom_topic.empty())
    tf_poses_ = std::make_unique<TfPoses>(parameters.fixed_frame, parameters.body_frame);
  for (const LidarPlace& lidar : lidar_places(parameters)) {
    options.T_body_sensor = lidar.T_body_sensor;
    add_lidar(nh, lidar.topic, options);
  }
  if (!tf_poses_)
    odometry_subscriber_ =
        nh.subscribe(parameters.odom_topic, kOdometryInTransit, &ScanInput::on_odometry, this);
  if (parameters.fixed_frame.empty() && !options.R_ros_odometry.isIdentity())
    axes_frame_ = std::make_unique<AxesFrame>(options.R_ros_odometry);
}

void ScanInput::add_lidar(ros::NodeHandle& nh, const std::string& topic, const PairingOptions& options) {
  const std::lock_guard lock(mutex_);
  lidars_.push_back(std::make_unique<Lidar>());
  Lidar& lidar = *lidars_.back();
  lidar.topic = topic;
  lidar.pairing =
      tf_poses_ ? std::make_unique<ScanPairing>(options, *tf_poses_) : std::make_unique<ScanPairing>(options);
  lidar.pairing->set_drop_listener(
      [this, topic](const std::string& reason, const std::string& text) { on_drop(topic, reason, text); });
  const boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_message =
      [this, &lidar](const sensor_msgs::PointCloud2ConstPtr& cloud) { on_cloud(lidar, cloud); };
  lidar.subscriber = nh.subscribe<sensor_msgs::PointCloud2>(topic, kCloudsInTransit, on_message);
}

void ScanInput::on_cloud(Lidar& lidar, const sensor_msgs::PointCloud2ConstPtr& cloud) {
  const auto arrived = Clock::now();
  const std::lock_guard lock(mutex_);
  lidar.silence.heard(arrived);
  cloud_frame_id_ = without_leading_slash(cloud->header.frame_id);
  if (lidar.pairing->waiting() == 0) lidar.last_taken = arrived;
  lidar.pairing->add_cloud(cloud, arrived);
  arrived_.notify_one();
}

void ScanInput::on_odometry(const nav_msgs::OdometryConstPtr& odometry) {
  const std::lock_guard lock(mutex_);
  odometry_silence_.heard(Clock::now());
  if (odometry_frame_.empty()) {
    too_early_ = 0;
    for (const auto& lidar : lidars_) too_early_ += lidar->pairing->waiting();
  }
  try {
    for (const auto& lidar : lidars_) lidar->pairing->add_odometry(*odometry);
    odometry_frame_ = without_leading_slash(odometry->header.frame_id);
    if (axes_frame_) axes_frame_->announce(odometry_frame_);
  } catch (const std::invalid_argument& error) {
    log_.warn("odometry", parameters_.odom_topic + ": a pose is not used: " + error.what() +
                              "; the odometry has failed or fills in its message wrongly");
  }
  arrived_.notify_one();
}

std::optional<PairedScan> ScanInput::next(std::chrono::milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  const std::chrono::milliseconds tf_poll(5);  // nobody calls when a transform comes
  std::unique_lock lock(mutex_);
  for (;;) {
    if (std::optional<PairedScan> paired = take()) return paired;
    for (const auto& lidar : lidars_) warn_when_waiting_long(*lidar);
    const auto now = Clock::now();
    if (now >= deadline) return std::nullopt;
    arrived_.wait_until(lock, tf_poses_ ? std::min<Clock::time_point>(deadline, now + tf_poll) : deadline);
  }
}

/// The oldest scan, of any LiDAR, whose pose is known: none waits for another one's pose.
std::optional<PairedScan> ScanInput::take() {
  std::vector<std::pair<std::int64_t, std::size_t>> by_age;
  for (std::size_t i = 0; i < lidars_.size(); ++i) {
    const auto oldest_ns = lidars_[i]->pairing->oldest_stamp_ns();
    if (oldest_ns) by_age.emplace_back(*oldest_ns, i);
  }
  std::sort(by_age.begin(), by_age.end());
  for (const auto& [stamp_ns, i] : by_age) {
    std::optional<PairedScan> paired = take(*lidars_[i]);
    if (!paired) continue;
    paired->scan.sensor = static_cast<int>(i);
    return paired;
  }
  return std::nullopt;
}

std::optional<PairedScan> ScanInput::take(Lidar& lidar) {
  std::optional<PairedScan> paired;
  try {
    paired = lidar.pairing->next();
  } catch (const std::runtime_error& error) {
    log_.warn("unreadable " + lidar.topic, lidar.topic + ": a scan is dropped: " + error.what());
  }
  if (paired) ++taken_;
  if (paired) lidar.last_taken = Clock::now();
  return paired;
}

void ScanInput::warn_when_waiting_long(const Lidar& lidar) {
  if (lidar.pairing->waiting() == 0 || Clock::now() - lidar.last_taken < kLongWait) return;
  log_.warn("waiting " + lidar.topic, lidar.topic + ": " + std::to_string(lidar.pairing->waiting()) +
                                          " scans wait for their pose: " + lidar.pairing->waiting_for() +
                                          advice("no_pose", parameters_));
}

void ScanInput::warn_of_silence() {
  for (const auto& lidar : lidars_)
    warn_of_silence(lidar->silence, lidar->subscriber, "sensor_msgs/PointCloud2", "cloud_topic");
  if (!tf_poses_) warn_of_silence(odometry_silence_, odometry_subscriber_, "nav_msgs/Odometry", "odom_topic");
}

void ScanInput::warn_of_silence(SilenceWatch& watch, const ros::Subscriber& subscriber, const char* type,
                                const char* parameter) {
  std::optional<std::chrono::seconds> silence;
  {
    const std::lock_guard lock(mutex_);
    silence = watch.due(Clock::now());
  }
  if (!silence) return;
  const ListenedTopic topic{subscriber.getTopic(), type, parameter};
  const ros::master::V_TopicInfo published = published_topics_now();  // not under the lock: may take long
  log_.warn("silent " + topic.name,
            topic.name + ": nothing has come for " + std::to_string(silence->count()) +
                " s: " + why_silent(topic, subscriber.getNumPublishers(), published, own_prefix_));
}

void ScanInput::on_drop(const std::string& topic, const std::string& reason, const std::string& text) {
  if (reason == "no_pose") count_without_pose(text);
  const std::string what = reason == "jumped_back" ? ": " : ": a scan is dropped: ";
  log_.warn(reason + " " + topic, topic + what + text + advice(reason, parameters_));
}

void ScanInput::count_without_pose(const std::string& why) {
  if (!tf_poses_ && odometry_frame_.empty()) return;  // the odometry has not begun
  if (too_early_ > 0) {
    --too_early_;
    return;
  }
  ++without_pose_;
  why_no_pose_ = why;
}

void ScanInput::close() {
  for (const auto& lidar : lidars_) lidar->subscriber.shutdown();
  odometry_subscriber_.shutdown();
}

std::size_t ScanInput::waiting() const {
  const std::lock_guard lock(mutex_);
  std::size_t waiting = 0;
  for (const auto& lidar : lidars_) waiting += lidar->pairing->waiting();
  return waiting;
}

std::map<std::string, std::uint64_t> ScanInput::dropped() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, std::uint64_t> dropped;
  for (const auto& lidar : lidars_)
    for (const auto& [reason, scans] : lidar->pairing->dropped()) dropped[reason] += scans;
  return dropped;
}

std::string ScanInput::fixed_frame() const {
  if (!parameters_.fixed_frame.empty()) return without_leading_slash(parameters_.fixed_frame);
  const std::lock_guard lock(mutex_);
  return axes_frame_ ? AxesFrame::name_of(odometry_frame_) : odometry_frame_;
}

}  // namespace stillmap
