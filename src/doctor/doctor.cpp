#include "doctor/doctor.hpp"

#include <cmath>

#include "doctor/cloud_density.hpp"
#include "doctor/ray_origin.hpp"
#include "doctor/rows.hpp"
#include "doctor/up_axis.hpp"

namespace stillmap {
namespace {

// Scans that are looked at alone.
constexpr std::size_t kFirstLook = 4, kSecondLook = 14;
// Motion after which the frames can be judged: surely, or a little when the twenty scans are over.
constexpr double kWay_m = 3.0, kTurn_rad = 0.5, kLittleWay_m = 1.0, kLittleTurn_rad = 0.2;
constexpr double kStands_m = 0.1, kStands_rad = 0.03;
constexpr std::size_t kPatience = 3000;  // scans to wait for motion
constexpr double kMuchMoves = 0.3;       // of the returns; a crowded place has a tenth

}  // namespace

std::vector<Finding> Doctor::add(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                                 const LabelCounts& counts) {
  std::vector<Finding> found;
  if (is_done()) return found;
  if (scans_ == kFirstLook || scans_ == kSecondLook) look_at_scan(scan, T_map_sensor, found);
  if (!frames_are_judged_) look_at_motion(scan, T_map_sensor, found);
  if (scans_ < kScans) look_at_outcome(counts, found);
  ++scans_;
  return found;
}

void Doctor::look_at_scan(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                          std::vector<Finding>& found) {
  const std::vector<std::optional<Finding>> looks = {check_rows(scan), check_density(scan),
                                                     check_up_axis(scan, T_map_sensor, said_),
                                                     check_ray_origin(scan, said_)};
  for (std::size_t i = 0; i < first_look_.size(); ++i)
    if (first_look_[i] && looks[i]) found.push_back(*looks[i]);
  first_look_ = looks;
}

void Doctor::look_at_motion(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                            std::vector<Finding>& found) {
  const bool is_last_of_first = scans_ + 1 == kScans;
  if (!reference_) {
    reference_ = as_sent(scan, T_map_sensor, said_);
    return;
  }
  const Eigen::Isometry3d T_odom_body = as_sent({}, T_map_sensor, said_).T_odom_body;
  const Motion motion = motion_between(*reference_, {{}, T_odom_body});
  const bool has_moved = motion.way_m > kWay_m || motion.turn_rad > kTurn_rad;
  if (!has_moved && !is_last_of_first) {
    frames_are_judged_ = scans_ > kPatience;
    return;
  }
  const AsSent now = as_sent(scan, T_map_sensor, said_);
  std::optional<Finding> finding;
  if (has_moved || motion.way_m > kLittleWay_m || motion.turn_rad > kLittleTurn_rad)
    finding = check_frames(*reference_, now, said_);
  else if (motion.way_m < kStands_m && motion.turn_rad < kStands_rad)
    finding = check_still(*reference_, now, said_);
  if (finding) found.push_back(*finding);
  frames_are_judged_ = has_moved || finding;
}

void Doctor::look_at_outcome(const LabelCounts& counts, std::vector<Finding>& found) {
  if (scans_ < kScans / 2) return;
  dynamic_ += counts.dynamic;
  judged_ += counts.dynamic + counts.is_static + counts.uncertain;
  if (scans_ + 1 < kScans || judged_ == 0 || double(dynamic_) < kMuchMoves * double(judged_)) return;
  found.push_back(
      {"outcome", std::to_string(std::lround(100.0 * double(dynamic_) / double(judged_))) +
                      " % of the returns are called moving: the poses or frames do not fit the clouds; "
                      "check cloud_frame, sensor_on_body and odom_topic"});
}

}  // namespace stillmap
