#include "trajectory.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace stillmap {
namespace {

bool earlier(const StampedPose& a, const StampedPose& b) {
  return a.stamp_ns < b.stamp_ns;
}

/// The pose at a stamp between the first and the last.
Eigen::Isometry3d pose_at(const std::vector<StampedPose>& poses, std::int64_t stamp_ns) {
  const auto after = std::lower_bound(poses.begin(), poses.end(), StampedPose{stamp_ns, {}}, earlier);
  if (after == poses.begin()) return poses.front().T_map_sensor;
  if (after == poses.end()) return poses.back().T_map_sensor;
  const auto before = after - 1;
  const double share = static_cast<double>(stamp_ns - before->stamp_ns) /
                       static_cast<double>(after->stamp_ns - before->stamp_ns);
  return interpolated(before->T_map_sensor, after->T_map_sensor, share);
}

std::string seconds(const std::vector<StampedPose>& poses) {
  if (poses.empty()) return "none";
  std::ostringstream text;
  text.precision(3);
  text << std::fixed << static_cast<double>(poses.front().stamp_ns) * 1e-9 << " to "
       << static_cast<double>(poses.back().stamp_ns) * 1e-9 << " s";
  return text.str();
}

}  // namespace

Eigen::Isometry3d interpolated(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double share) {
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear()));
  const Eigen::Vector3d translation = (1 - share) * a.translation() + share * b.translation();
  return Eigen::Translation3d(translation) * rotation.normalized();
}

void PastCorrection::add(std::int64_t stamp_ns, const Eigen::Isometry3d& T_new_old) {
  steps_.push_back({stamp_ns, T_new_old});
}

Eigen::Isometry3d PastCorrection::at(std::int64_t stamp_ns) const {
  return pose_at(steps_, stamp_ns);
}

void Trajectory::add(const StampedPose& pose) {
  // Stamps that jump back (a bag that loops) begin a new past.
  if (!poses_.empty() && pose.stamp_ns <= poses_.back().stamp_ns) poses_.clear();
  poses_.push_back(pose);
}

PastCorrection Trajectory::correction(std::vector<StampedPose> corrected) const {
  std::sort(corrected.begin(), corrected.end(), earlier);
  PastCorrection correction;
  for (const StampedPose& pose : corrected) {
    if (poses_.empty() || pose.stamp_ns < poses_.front().stamp_ns || pose.stamp_ns > poses_.back().stamp_ns)
      continue;
    correction.add(pose.stamp_ns, pose.T_map_sensor * pose_at(poses_, pose.stamp_ns).inverse());
  }
  if (correction.empty())
    throw std::invalid_argument("the corrected path has " + std::to_string(corrected.size()) + " poses (" +
                                seconds(corrected) + "), none of them in the time of the scans (" +
                                seconds(poses_) + "); is it the path of this run, with the same clock?");
  return correction;
}

PastCorrection Trajectory::spread(const Eigen::Isometry3d& T_new_old, std::int64_t since_ns) const {
  PastCorrection correction;
  if (poses_.empty()) return correction;
  std::vector<double> way_m(poses_.size(), 0);
  const Eigen::Vector3d start = pose_at(poses_, since_ns).translation();
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    const bool moves = poses_[i].stamp_ns > since_ns;
    const Eigen::Vector3d step =
        poses_[i].T_map_sensor.translation() - poses_[i - 1].T_map_sensor.translation();
    way_m[i] = way_m[i - 1] + (moves ? step.norm() : 0.0);
  }
  // Turns about where the error began, so that a turn moves nothing there.
  const Eigen::Translation3d to_start(-start), back(start);
  const Eigen::Isometry3d whole = to_start * T_new_old * back;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const double share = way_m.back() > 0 ? way_m[i] / way_m.back() : 1.0;
    correction.add(poses_[i].stamp_ns,
                   back * interpolated(Eigen::Isometry3d::Identity(), whole, share) * to_start);
  }
  return correction;
}

void Trajectory::apply(const PastCorrection& correction) {
  for (StampedPose& pose : poses_) pose.T_map_sensor = correction.at(pose.stamp_ns) * pose.T_map_sensor;
}

}  // namespace stillmap
