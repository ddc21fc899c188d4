#include "messages/frame_id.hpp"
#include "ros/scan_input.hpp"

namespace stillmap {

InputFacts ScanInput::facts() const {
  constexpr std::chrono::seconds kClockPatience(5);
  InputFacts facts;
  facts.clock_stands =
      ros::Time::isSimTime() && ros::Time::now().isZero() && Clock::now() - start_ > kClockPatience;
  const std::lock_guard lock(mutex_);
  facts.answered = taken_;
  facts.clouds = taken_ + without_pose_;
  facts.why_not = why_no_pose_;
  for (const auto& lidar : lidars_) {
    const std::string why = lidar->pairing->waiting_for();
    if (why.empty()) continue;  // what waits behind a full queue of work has a pose
    if (tf_poses_) facts.clouds += lidar->pairing->waiting();
    if (facts.why_not.empty()) facts.why_not = why;
  }
  facts.uses_tf = tf_poses_ != nullptr;
  if (!tf_poses_ || taken_ > 0) return facts;
  facts.tf_frames = tf_poses_->known_frames();
  facts.needed_frames = {
      without_leading_slash(parameters_.fixed_frame),
      parameters_.body_frame.empty() ? cloud_frame_id_ : without_leading_slash(parameters_.body_frame)};
  return facts;
}

}  // namespace stillmap
