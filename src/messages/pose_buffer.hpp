#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace stillmap {

/// Where the body was at a stamp: known, not known yet, or never to be known.
struct PoseAnswer {
  enum class Kind { kFound, kWait, kNever };
  Kind kind = Kind::kWait;
  Eigen::Isometry3d T_map_body = Eigen::Isometry3d::Identity();
  std::string why;  ///< of kWait and kNever
};

/// Gives the body's pose for a cloud; the odometry and tf2 are such sources.
class PoseSource {
 public:
  virtual ~PoseSource() = default;
  /// `cloud_frame_id` is the cloud's header frame, for a source that knows frames.
  virtual PoseAnswer at(std::int64_t stamp_ns, const std::string& cloud_frame_id) const = 0;
};

/// Stamped poses; in between them it interpolates.
class PoseBuffer : public PoseSource {
 public:
  /// Forgets the oldest poses beyond `capacity`.
  explicit PoseBuffer(double max_gap_s, std::size_t capacity = std::numeric_limits<std::size_t>::max());

  /// A second pose of one stamp replaces the first.
  void add(std::int64_t stamp_ns, const Eigen::Isometry3d& T_map_body);
  void clear() { poses_.clear(); }
  bool empty() const { return poses_.empty(); }
  std::int64_t newest_stamp_ns() const { return poses_.rbegin()->first; }

  PoseAnswer at(std::int64_t stamp_ns, const std::string& cloud_frame_id = "") const override;

 private:
  double max_gap_s_;
  std::size_t capacity_;
  std::map<std::int64_t, Eigen::Isometry3d> poses_;
};

}  // namespace stillmap
