#pragma once

#include <string>

#include "messages/pairing_options.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {

/// What the node takes beside the method's Parameters. Names, units, ranges and meanings stand once, in
/// visit_node_parameters().
struct NodeParameters {
  std::string odometry_preset = "generic";
  std::string cloud_topic = "/cloud_registered";
  std::string odom_topic = "/Odometry";
  std::string cloud_frame = "world";
  std::string sensor_on_body = "0 0 0 0 0 0";
  std::string odometry_axes = "ros";
  std::string fixed_frame;
  std::string body_frame;
  double max_odometry_gap_s = 0.5;
  int queue_size = 10;
  double max_cloud_mb = 100;
  std::string after_jump_back = "keep_map";
  int resolved_delay = 10;
  double map_period_s = 2.0;
  double box_lifetime_s = 0.3;
  std::string corrected_path_topic;
  std::string odom_frame;
  std::string map_directory = "~/.ros/stillmap";
  std::string load_map;
  std::string save_map;
  double save_map_idle_s = 3.0;
};

/// As visit_parameters().
template <class ParametersT, class Visitor>
void visit_node_parameters(ParametersT& p, Visitor&& visit) {
  const auto text = [&](const char* name, auto& value, const char* help) {
    visit(ParameterInfo{name, "", 0, 0, "", help}, value);
  };
  const auto number = [&](const char* name, const char* unit, double min, double max, auto& value,
                          const char* help) {
    visit(ParameterInfo{name, unit, min, max, "", help}, value);
  };

  text("odometry_preset", p.odometry_preset,
       "the odometry package, a file of config/presets: what it says stands for all parameters not given");
  text("cloud_topic", p.cloud_topic,
       "the scans, sensor_msgs/PointCloud2; of several LiDARs with spaces between");
  text("odom_topic", p.odom_topic, "the poses, nav_msgs/Odometry; empty = tf2");
  text("cloud_frame", p.cloud_frame, "the frame that x, y, z are in: world, body or sensor");
  text("sensor_on_body", p.sensor_on_body,
       "x y z roll_deg pitch_deg yaw_deg, or x y z qx qy qz qw; of several LiDARs with ; between");
  text("odometry_axes", p.odometry_axes,
       "of the odometry's two frames: ros (x ahead, y left, z up) or loam (x left, y up, z ahead)");
  text("fixed_frame", p.fixed_frame,
       "the map's frame; needed with tf2, else empty = the odometry's, with loam axes followed by _z_up");
  text("body_frame", p.body_frame, "tf2 frame whose pose is looked up; empty = the cloud's own frame");
  number("max_odometry_gap_s", "s", 0.01, 60.0, p.max_odometry_gap_s,
         "longest time between two odometry messages to interpolate over");
  number("queue_size", "scans", 1, 1000, p.queue_size, "scans that may wait; beyond, the oldest is dropped");
  number("max_cloud_mb", "MB", 0.001, 1000.0, p.max_cloud_mb, "a larger cloud is dropped as it comes");
  text("after_jump_back", p.after_jump_back,
       "when the stamps jump back by more than a second (a recording that loops): keep_map or new_map");
  number(
      "resolved_delay", "scans", 0, 1000, p.resolved_delay,
      "~resolved has each scan judged again so many scans later; so many are kept in memory while somebody "
      "listens; 0 = off");
  number("map_period_s", "s", 0.1, 3600.0, p.map_period_s, "shortest time between two maps");
  number("box_lifetime_s", "s", 0.0, 60.0, p.box_lifetime_s,
         "how long rviz shows a box of ~moving_boxes; 0 = until the next with its number");
  text("corrected_path_topic", p.corrected_path_topic,
       "nav_msgs/Path of the body after loop closures: the map follows it, with submap_length_m; empty = "
       "none");
  text(
      "odom_frame", p.odom_frame,
      "tf2 frame: when fixed_frame <- odom_frame jumps, the map follows, with submap_length_m; empty = none");
  text("map_directory", p.map_directory,
       "folder that files named in calls of ~save_map, ~load_map and ~diff_map must lie in");
  text("load_map", p.load_map, "a .stillmap to go on with; may be that of save_map; empty = none");
  text("save_map", p.save_map, ".stillmap, .pcd, .ply, .bt or .ot where the map is saved; empty = nowhere");
  number("save_map_idle_s", "s", 0.5, 3600.0, p.save_map_idle_s,
         "no scan for so long means that they have ceased: save_map is written, ~resolved gets what still "
         "waits");
}

/// How scans of the first LiDAR are paired. Throws std::invalid_argument naming the parameters that are out
/// of range or do not go together.
PairingOptions check_node_parameters(const NodeParameters& parameters);

}  // namespace stillmap
