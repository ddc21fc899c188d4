#pragma once

#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <string>
#include <vector>

#include "messages/pose_buffer.hpp"

namespace stillmap {

/// The pose of `frame` in `fixed_frame`; kNever where tf2 knows later ones only. Another thread may hand
/// transforms to the buffer meanwhile.
PoseAnswer pose_in(const tf2::BufferCore& buffer, const std::string& fixed_frame, const std::string& frame,
                   std::int64_t stamp_ns);

/// The body's poses from tf2; never waits itself.
class TfPoses : public PoseSource {
 public:
  /// An empty body_frame is the cloud's own frame.
  TfPoses(const std::string& fixed_frame, const std::string& body_frame);
  PoseAnswer at(std::int64_t stamp_ns, const std::string& cloud_frame_id) const override;
  std::vector<std::string> known_frames() const;

 private:
  std::string fixed_frame_, body_frame_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};

}  // namespace stillmap
