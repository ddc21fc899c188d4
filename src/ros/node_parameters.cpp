#include "ros/node_parameters.hpp"

#include <sstream>
#include <stdexcept>

#include "ros/lidar_places.hpp"

namespace stillmap {
namespace {

struct RangeCheck {
  void operator()(const ParameterInfo&, const std::string&) const {}
  void operator()(const ParameterInfo& info, double value) const {
    if (value >= info.min && value <= info.max) return;
    std::ostringstream text;
    text << info.name << ": " << value << " is not in [" << info.min << ", " << info.max << "] " << info.unit;
    throw std::invalid_argument(text.str());
  }
};

// With tf2 alone, the frames must say where the sensor is, once.
void check_tf_frames(const NodeParameters& p, const PairingOptions& options) {
  if (p.fixed_frame.empty())
    throw std::invalid_argument(
        "fixed_frame: needed when odom_topic is empty; give the tf2 frame of the map");
  if (!options.R_ros_odometry.isIdentity())
    throw std::invalid_argument(
        "odometry_axes: must be ros when odom_topic is empty; name frames with z up in fixed_frame and "
        "body_frame");
  if (!p.body_frame.empty()) return;
  if (options.cloud_frame == CloudFrame::kWorld)
    throw std::invalid_argument(
        "body_frame: needed when odom_topic is empty and cloud_frame is world; give the sensor's tf2 frame");
  if (options.cloud_frame == CloudFrame::kSensor &&
      !options.T_body_sensor.isApprox(Eigen::Isometry3d::Identity()))
    throw std::invalid_argument(
        "sensor_on_body: must be 0 0 0 0 0 0 when odom_topic is empty and cloud_frame is sensor, as tf2 "
        "gives "
        "the sensor's own pose; or name the body in body_frame");
}

}  // namespace

PairingOptions check_node_parameters(const NodeParameters& parameters) {
  visit_node_parameters(parameters, RangeCheck());
  PairingOptions options;
  options.cloud_frame = parse_cloud_frame(parameters.cloud_frame);
  options.R_ros_odometry = parse_odometry_axes(parameters.odometry_axes);
  options.T_body_sensor = lidar_places(parameters).front().T_body_sensor;
  options.max_gap_s = parameters.max_odometry_gap_s;
  options.queue_size = static_cast<std::size_t>(parameters.queue_size);
  options.max_cloud_bytes = static_cast<std::size_t>(parameters.max_cloud_mb * 1e6);
  if (parameters.after_jump_back != "keep_map" && parameters.after_jump_back != "new_map")
    throw std::invalid_argument("after_jump_back: '" + parameters.after_jump_back +
                                "' is not one of keep_map|new_map");
  if (parameters.odom_topic.empty()) check_tf_frames(parameters, options);
  return options;
}

}  // namespace stillmap
