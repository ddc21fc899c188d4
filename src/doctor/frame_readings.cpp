#include "doctor/frame_readings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

#include "doctor/up_axis.hpp"

namespace stillmap {
namespace {

// Of the upright things in two scans that are a few metres apart, so large a share falls on each other: in
// true readings 0.6 to 0.9, in wrong ones 0.2 to 0.8.
constexpr double kFits = 0.75, kFitsBetter = 0.17, kFitsNothing = 0.22;
constexpr double kStillFits = 0.6;

constexpr double kCell_m = 0.25, kReach_m = 25.0, kUpright_m = 0.5;
constexpr std::size_t kEnoughCells = 30, kPoints = 40'000;

/// One way to understand the message.
struct Reading {
  CloudFrame frame;
  const char* axes;
  Eigen::Isometry3d to_map(const Eigen::Isometry3d& T_odom_body, const PairingOptions& said) const {
    const Eigen::Isometry3d R(parse_odometry_axes(axes));
    if (frame == CloudFrame::kWorld) return R;
    if (frame == CloudFrame::kBody) return R * T_odom_body;
    return R * T_odom_body * R.inverse() * said.T_body_sensor;
  }
};

const char* name_of(CloudFrame frame) {
  return frame == CloudFrame::kWorld ? "world" : frame == CloudFrame::kBody ? "body" : "sensor";
}

struct Column {
  std::int32_t x, y;
  float z;
  bool is_in(const Column& other) const { return x == other.x && y == other.y; }
  bool operator<(const Column& other) const { return x != other.x ? x < other.x : y < other.y; }
};

/// The cells of the plan where something stands upright; sorted.
std::vector<Column> upright_cells(const AsSent& scan, const Eigen::Isometry3d& T_map_message,
                                  const Eigen::Vector3d& around) {
  std::vector<Column> all, upright;
  const std::size_t step = scan.points.size() / kPoints + 1;
  for (std::size_t i = 0; i < scan.points.size(); i += step) {
    if (!scan.points[i].allFinite()) continue;
    const Eigen::Vector3d p = T_map_message * scan.points[i].cast<double>();
    if ((p - around).norm() < kReach_m && (p - around).norm() > 1.0)
      all.push_back({int(std::floor(p.x() / kCell_m)), int(std::floor(p.y() / kCell_m)), float(p.z())});
  }
  std::sort(all.begin(), all.end());
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(first, all.end(), [&](const Column& c) { return !c.is_in(*first); });
    const auto [low, high] =
        std::minmax_element(first, last, [](const Column& a, const Column& b) { return a.z < b.z; });
    if (high->z - low->z > kUpright_m) upright.push_back(*first);
    first = last;
  }
  return upright;
}

double share_found(const std::vector<Column>& cells, const std::vector<Column>& in) {
  std::size_t found = 0;
  for (const Column& cell : cells) {
    bool any = false;
    for (int i = 0; i < 9 && !any; ++i)
      any = std::binary_search(in.begin(), in.end(), Column{cell.x + i % 3 - 1, cell.y + i / 3 - 1, 0});
    found += any;
  }
  return double(found) / double(cells.size());
}

/// Of the upright things in the two, the share that falls on each other; -1 if there are too few.
double fit(const AsSent& a, const AsSent& b, const Reading& reading, const PairingOptions& said) {
  const auto cells_of = [&](const AsSent& scan) {
    const Eigen::Matrix3d R = parse_odometry_axes(reading.axes);
    return upright_cells(scan, reading.to_map(scan.T_odom_body, said), R * scan.T_odom_body.translation());
  };
  const std::vector<Column> in_a = cells_of(a), in_b = cells_of(b);
  if (in_a.size() < kEnoughCells || in_b.size() < kEnoughCells) return -1;
  return 0.5 * (share_found(in_a, in_b) + share_found(in_b, in_a));
}

/// Seen from the sensor's place, no wide plane stands upright.
bool is_upright(const AsSent& scan, const Reading& reading, const PairingOptions& said) {
  const Eigen::Isometry3d T = reading.to_map(scan.T_odom_body, said);
  const Eigen::Vector3d place = parse_odometry_axes(reading.axes) * scan.T_odom_body.translation();
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& point : scan.points)
    points.push_back((T * point.cast<double>() - place).cast<float>());
  return widest_plane(points).lies_across == 'z';
}

const char* said_axes(const PairingOptions& said) {
  return said.R_ros_odometry.isIdentity() ? "ros" : "loam";
}

}  // namespace

AsSent as_sent(const Scan& scan, const Eigen::Isometry3d& T_map_sensor, const PairingOptions& said) {
  const Eigen::Isometry3d R(said.R_ros_odometry);
  Eigen::Isometry3d T_message_sensor = Eigen::Isometry3d::Identity();
  if (said.cloud_frame == CloudFrame::kWorld) T_message_sensor = R.inverse() * T_map_sensor;
  if (said.cloud_frame == CloudFrame::kBody) T_message_sensor = R.inverse() * said.T_body_sensor;
  AsSent sent{{}, R.inverse() * T_map_sensor * said.T_body_sensor.inverse() * R};
  sent.points.reserve(scan.points.size());
  for (const Eigen::Vector3f& point : scan.points)
    if (point.allFinite() && !point.isZero(0))
      sent.points.push_back((T_message_sensor * point.cast<double>()).cast<float>());
  return sent;
}

Motion motion_between(const AsSent& a, const AsSent& b) {
  const Eigen::Isometry3d T = a.T_odom_body.inverse() * b.T_odom_body;
  return {T.translation().norm(), std::abs(Eigen::AngleAxisd(T.linear()).angle())};
}

std::optional<Finding> check_frames(const AsSent& a, const AsSent& b, const PairingOptions& said) {
  const Reading given{said.cloud_frame, said_axes(said)};
  const double given_fit = fit(a, b, given, said);
  // World and body clouds fit alike in both axes: check_up_axis tells those apart.
  Reading best = given;
  double best_fit = given_fit;
  for (const Reading& reading :
       {Reading{CloudFrame::kWorld, given.axes}, Reading{CloudFrame::kSensor, "ros"},
        Reading{CloudFrame::kSensor, "loam"}, Reading{CloudFrame::kBody, given.axes}}) {
    const double found = fit(a, b, reading, said);
    if (found > best_fit + 0.01 && is_upright(b, reading, said))  // alike: the one before
      best = reading, best_fit = found;
  }
  std::ostringstream text;
  std::map<std::string, std::string> mend;
  const auto percent = [](double share) { return std::lround(100 * std::max(0.0, share)); };
  if (best_fit > kFits && best_fit > given_fit + kFitsBetter) {
    text << "read as cloud_frame " << name_of(given.frame) << ", " << percent(given_fit)
         << " % of what stands falls on itself after " << motion_between(a, b).way_m << " m; as "
         << name_of(best.frame) << ", " << percent(best_fit) << " %: set cloud_frame to "
         << name_of(best.frame);
    mend["cloud_frame"] = name_of(best.frame);
    if (best.axes != std::string(given.axes)) {
      text << " and odometry_axes to " << best.axes;
      mend["odometry_axes"] = best.axes;
    }
  } else if (given_fit >= 0 && given_fit < kFitsNothing) {
    text << "only " << percent(given_fit) << " % of what stands falls on itself after "
         << motion_between(a, b).way_m
         << " m, in any reading of the frames: check the rotation in sensor_on_body, "
         << "and that odom_topic is of this sensor";
  } else {
    return std::nullopt;
  }
  return Finding{"frames", text.str(), mend};
}

std::optional<Finding> check_still(const AsSent& a, const AsSent& b, const PairingOptions& said) {
  const double share = fit(a, b, {said.cloud_frame, said_axes(said)}, said);
  if (share < 0 || share > kStillFits) return std::nullopt;
  std::ostringstream text;
  text << "the odometry stands (" << motion_between(a, b).way_m << " m), but only "
       << std::lround(100 * share)
       << " % of what was seen is where it was: set odom_topic to one that follows the sensor";
  return Finding{"still", text.str()};
}

}  // namespace stillmap
