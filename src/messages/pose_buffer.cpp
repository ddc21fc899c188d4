#include "messages/pose_buffer.hpp"

#include <iterator>

namespace stillmap {
namespace {

// PCL cuts stamps to microseconds, a double rounds them to a quarter of one: nearer is the same moment.
constexpr std::int64_t kSameMoment_ns = 2'000;

Eigen::Isometry3d interpolate(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double t) {
  const Eigen::Vector3d translation = (1 - t) * a.translation() + t * b.translation();
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(a.linear()).slerp(t, Eigen::Quaterniond(b.linear()));
  return Eigen::Translation3d(translation) * rotation.normalized();
}

std::string seconds(std::int64_t ns) {
  return std::to_string(double(ns) * 1e-9) + " s";
}

}  // namespace

PoseBuffer::PoseBuffer(double max_gap_s, std::size_t capacity) : max_gap_s_(max_gap_s), capacity_(capacity) {}

void PoseBuffer::add(std::int64_t stamp_ns, const Eigen::Isometry3d& T_map_body) {
  poses_[stamp_ns] = T_map_body;
  if (poses_.size() > capacity_) poses_.erase(poses_.begin());
}

PoseAnswer PoseBuffer::at(std::int64_t stamp_ns, const std::string&) const {
  PoseAnswer answer;
  const auto same = poses_.lower_bound(stamp_ns - kSameMoment_ns);
  if (same != poses_.end() && same->first <= stamp_ns + kSameMoment_ns) {
    answer.kind = PoseAnswer::Kind::kFound;
    answer.T_map_body = same->second;
    return answer;
  }
  const auto after = poses_.lower_bound(stamp_ns);
  if (after == poses_.end()) {
    answer.why = poses_.empty() ? "no odometry has come yet"
                                : "the newest odometry is " + seconds(stamp_ns - newest_stamp_ns()) +
                                      " older than the cloud";
    return answer;
  }
  answer.kind = PoseAnswer::Kind::kNever;
  if (after == poses_.begin()) {
    answer.why = "the oldest odometry is " + seconds(after->first - stamp_ns) + " newer than the cloud";
    return answer;
  }
  const auto before = std::prev(after);
  const std::int64_t gap_ns = after->first - before->first;
  if (double(gap_ns) * 1e-9 > max_gap_s_) {
    answer.why = "the odometry has a gap of " + seconds(gap_ns) + " around the cloud, more than " +
                 std::to_string(max_gap_s_) + " s";
    return answer;
  }
  answer.kind = PoseAnswer::Kind::kFound;
  answer.T_map_body =
      interpolate(before->second, after->second, double(stamp_ns - before->first) / double(gap_ns));
  return answer;
}

}  // namespace stillmap
