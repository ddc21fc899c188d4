#include "ros/scan_input.hpp"

#include <algorithm>
#include <stdexcept>

#include "messages/frame_id.hpp"

namespace stillmap {
namespace {

constexpr int kCloudsInTransit = 100, kOdometryInTransit = 2000;
constexpr std::chrono::seconds kLongWait(2), kClockPatience(5);

std::string advice(const std::string& reason) {
  if (reason == "queue_full") return "; give more threads, a larger voxel_size_m or queue_size";
  if (reason == "no_pose") return "; check odom_topic, fixed_frame and the stamps of both";
  if (reason == "late") return "; the publisher must give each scan its own, growing stamp";
  if (reason == "jumped_back") return "; the map is kept: call ~reset to begin anew";
  return "";
}

}  // namespace

ScanInput::ScanInput(ros::NodeHandle nh, const NodeParameters& parameters, const std::string& own_prefix,
                     ThrottledLog& log)
    : parameters_(parameters), own_prefix_(own_prefix), log_(log) {
  const PairingOptions options = check_node_parameters(parameters);
  if (parameters.odom_topic.empty()) {
    tf_poses_ = std::make_unique<TfPoses>(parameters.fixed_frame, parameters.body_frame);
    pairing_ = std::make_unique<ScanPairing>(options, *tf_poses_);
  } else {
    pairing_ = std::make_unique<ScanPairing>(options);
    odometry_subscriber_ =
        nh.subscribe(parameters.odom_topic, kOdometryInTransit, &ScanInput::on_odometry, this);
  }
  if (parameters.fixed_frame.empty() && !options.R_ros_odometry.isIdentity())
    axes_frame_ = std::make_unique<AxesFrame>(options.R_ros_odometry);
  pairing_->set_drop_listener(
      [this](const std::string& reason, const std::string& text) { on_drop(reason, text); });
  cloud_subscriber_ = nh.subscribe(parameters.cloud_topic, kCloudsInTransit, &ScanInput::on_cloud, this);
}

void ScanInput::on_cloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  const std::lock_guard lock(mutex_);
  cloud_silence_.heard(Clock::now());
  cloud_frame_id_ = without_leading_slash(cloud->header.frame_id);
  pairing_->add_cloud(cloud);
  arrived_.notify_one();
}

void ScanInput::on_odometry(const nav_msgs::OdometryConstPtr& odometry) {
  const std::lock_guard lock(mutex_);
  odometry_silence_.heard(Clock::now());
  if (odometry_frame_.empty()) too_early_ = pairing_->waiting();
  try {
    pairing_->add_odometry(*odometry);
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
    warn_when_waiting_long();
    const auto now = Clock::now();
    if (now >= deadline) return std::nullopt;
    arrived_.wait_until(lock, tf_poses_ ? std::min<Clock::time_point>(deadline, now + tf_poll) : deadline);
  }
}

std::optional<PairedScan> ScanInput::take() {
  std::optional<PairedScan> paired;
  try {
    paired = pairing_->next();
  } catch (const std::runtime_error& error) {
    log_.warn("unreadable", parameters_.cloud_topic + ": a scan is dropped: " + error.what());
  }
  if (paired) ++taken_;
  if (paired || pairing_->waiting() == 0) last_taken_ = Clock::now();
  return paired;
}

void ScanInput::warn_when_waiting_long() {
  if (Clock::now() - last_taken_ < kLongWait) return;
  log_.warn("waiting", parameters_.cloud_topic + ": " + std::to_string(pairing_->waiting()) +
                           " scans wait for their pose: " + pairing_->waiting_for() + advice("no_pose"));
}

void ScanInput::warn_of_silence() {
  warn_of_silence(cloud_silence_, cloud_subscriber_, "sensor_msgs/PointCloud2", "cloud_topic");
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
  ros::master::V_TopicInfo published;
  ros::master::getTopics(published);  // not under the lock: may take long
  log_.warn(std::string("silent ") + parameter,
            topic.name + ": nothing has come for " + std::to_string(silence->count()) +
                " s: " + why_silent(topic, subscriber.getNumPublishers(), published, own_prefix_));
}

void ScanInput::on_drop(const std::string& reason, const std::string& text) {
  if (reason == "no_pose") count_without_pose(text);
  const std::string what = reason == "jumped_back" ? ": " : ": a scan is dropped: ";
  log_.warn(reason, parameters_.cloud_topic + what + text + advice(reason));
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
  cloud_subscriber_.shutdown();
  odometry_subscriber_.shutdown();
}

std::size_t ScanInput::waiting() const {
  const std::lock_guard lock(mutex_);
  return pairing_->waiting();
}

std::map<std::string, std::uint64_t> ScanInput::dropped() const {
  const std::lock_guard lock(mutex_);
  return pairing_->dropped();
}

InputFacts ScanInput::facts() const {
  InputFacts facts;
  facts.clock_stands =
      ros::Time::isSimTime() && ros::Time::now().isZero() && Clock::now() - start_ > kClockPatience;
  const std::lock_guard lock(mutex_);
  const bool oldest_waits = !pairing_->waiting_for().empty();
  facts.answered = taken_;
  facts.clouds = taken_ + without_pose_;
  if (tf_poses_ && oldest_waits) facts.clouds += pairing_->waiting();
  facts.why_not = why_no_pose_.empty() ? pairing_->waiting_for() : why_no_pose_;
  facts.uses_tf = tf_poses_ != nullptr;
  if (!tf_poses_ || taken_ > 0) return facts;
  facts.tf_frames = tf_poses_->known_frames();
  facts.needed_frames = {
      without_leading_slash(parameters_.fixed_frame),
      parameters_.body_frame.empty() ? cloud_frame_id_ : without_leading_slash(parameters_.body_frame)};
  return facts;
}

std::string ScanInput::fixed_frame() const {
  if (!parameters_.fixed_frame.empty()) return without_leading_slash(parameters_.fixed_frame);
  const std::lock_guard lock(mutex_);
  return axes_frame_ ? AxesFrame::name_of(odometry_frame_) : odometry_frame_;
}

}  // namespace stillmap
