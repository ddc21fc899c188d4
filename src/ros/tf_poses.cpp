#include "ros/tf_poses.hpp"

#include <geometry_msgs/TransformStamped.h>

#include <stdexcept>

#include "messages/frame_id.hpp"
#include "messages/pairing_options.hpp"

namespace stillmap {
namespace {

constexpr double kKept_s = 30.0;

Eigen::Isometry3d to_pose(const geometry_msgs::TransformStamped& transform) {
  const auto& p = transform.transform.translation;
  const auto& q = transform.transform.rotation;
  return checked_pose({p.x, p.y, p.z}, {q.w, q.x, q.y, q.z});
}

}  // namespace

TfPoses::TfPoses(const std::string& fixed_frame, const std::string& body_frame)
    : fixed_frame_(without_leading_slash(fixed_frame)),
      body_frame_(without_leading_slash(body_frame)),
      buffer_(ros::Duration(kKept_s)),
      listener_(buffer_) {}

PoseAnswer TfPoses::at(std::int64_t stamp_ns, const std::string& cloud_frame_id) const {
  const std::string frame = body_frame_.empty() ? without_leading_slash(cloud_frame_id) : body_frame_;
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(stamp_ns));
  PoseAnswer answer;
  try {
    answer.T_map_body = to_pose(buffer_.lookupTransform(fixed_frame_, frame, stamp));
    answer.kind = PoseAnswer::Kind::kFound;
    return answer;
  } catch (const tf2::TransformException& error) {
    answer.why = "tf2 has no " + fixed_frame_ + " <- " + frame + " at its stamp: " + error.what();
  } catch (const std::invalid_argument& error) {
    answer.kind = PoseAnswer::Kind::kNever;
    answer.why = "tf2's " + fixed_frame_ + " <- " + frame + ": " + error.what();
    return answer;
  }
  try {  // known at a later time only: the past will not come
    const auto latest = buffer_.lookupTransform(fixed_frame_, frame, ros::Time(0));
    if (latest.header.stamp >= stamp) answer.kind = PoseAnswer::Kind::kNever;
  } catch (const tf2::TransformException&) {
    return answer;  // not connected yet
  }
  return answer;
}

std::vector<std::string> TfPoses::known_frames() const {
  std::vector<std::string> frames;
  buffer_._getFrameStrings(frames);
  return frames;
}

}  // namespace stillmap
