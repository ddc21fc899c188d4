#pragma once

#include "stillmap/stamped_pose.hpp"

namespace stillmap {

/// What moves the past: T_new_old of the map frame, at some stamps and in between.
class PastCorrection {
 public:
  void add(std::int64_t stamp_ns, const Eigen::Isometry3d& T_new_old);  ///< by growing stamps
  bool empty() const { return steps_.empty(); }
  /// Before the first and after the last one, that one.
  Eigen::Isometry3d at(std::int64_t stamp_ns) const;

 private:
  std::vector<StampedPose> steps_;
};

/// All poses of the first LiDAR, by growing stamps.
class Trajectory {
 public:
  void add(const StampedPose& pose);
  const std::vector<StampedPose>& poses() const { return poses_; }

  /// What takes these poses to those of the corrected path. Throws std::invalid_argument when none of the
  /// path's stamps lies in the time of the scans.
  PastCorrection correction(std::vector<StampedPose> corrected) const;
  /// What takes the newest pose through `T_new_old` and leaves the poses until `since_ns` where they are: the
  /// error between is taken to have grown with the way.
  PastCorrection spread(const Eigen::Isometry3d& T_new_old, std::int64_t since_ns) const;
  void apply(const PastCorrection& correction);

 private:
  std::vector<StampedPose> poses_;
};

/// A pose between two, at `share` of the way.
Eigen::Isometry3d interpolated(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double share);

}  // namespace stillmap
