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

/// tf2 knows a transform at that time or later.
bool knows_later(const tf2::BufferCore& buffer, const std::string& fixed_frame, const std::string& frame,
                 const ros::Time& stamp) {
  try {
    return buffer.lookupTransform(fixed_frame, frame, ros::Time(0)).header.stamp >= stamp;
  } catch (const tf2::TransformException&) {
    return false;  // not connected yet
  }
}

}  // namespace

PoseAnswer pose_in(const tf2::BufferCore& buffer, const std::string& fixed_frame, const std::string& frame,
                   std::int64_t stamp_ns) {
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(stamp_ns));
  PoseAnswer answer;
  // Before it is looked up: a transform that comes between the two is found, or waited for.
  const bool past_will_not_come = knows_later(buffer, fixed_frame, frame, stamp);
  try {
    answer.T_map_body = to_pose(buffer.lookupTransform(fixed_frame, frame, stamp));
    answer.kind = PoseAnswer::Kind::kFound;
  } catch (const tf2::TransformException& error) {
    if (past_will_not_come) answer.kind = PoseAnswer::Kind::kNever;
    answer.why = "tf2 has no " + fixed_frame + " <- " + frame + " at its stamp: " + error.what();
  } catch (const std::invalid_argument& error) {
    answer.kind = PoseAnswer::Kind::kNever;
    answer.why = "tf2's " + fixed_frame + " <- " + frame + ": " + error.what();
  }
  return answer;
}

TfPoses::TfPoses(const std::string& fixed_frame, const std::string& body_frame)
    : fixed_frame_(without_leading_slash(fixed_frame)),
      body_frame_(without_leading_slash(body_frame)),
      buffer_(ros::Duration(kKept_s)),
      listener_(buffer_) {}

PoseAnswer TfPoses::at(std::int64_t stamp_ns, const std::string& cloud_frame_id) const {
  const std::string frame = body_frame_.empty() ? without_leading_slash(cloud_frame_id) : body_frame_;
  return pose_in(buffer_, fixed_frame_, frame, stamp_ns);
}

std::vector<std::string> TfPoses::known_frames() const {
  std::vector<std::string> frames;
  buffer_._getFrameStrings(frames);
  return frames;
}

}  // namespace stillmap
