#include "ros/node_interface.hpp"

namespace stillmap {

const std::vector<Endpoint>& published_topics() {
  static const std::string cloud = "sensor_msgs/PointCloud2";
  static const std::vector<Endpoint> topics = {
      {"static_points", cloud, "the scan's static rows: all its fields, its order, its stamp"},
      {"dynamic_points", cloud, "its dynamic rows"},
      {"uncertain_points", cloud, "its uncertain rows, and those without a usable return"},
      {"labelled_points", cloud, "the whole scan with p_static, label and reason added to each row"},
      {"resolved", cloud, "the same scan with its own stamp, judged again resolved_delay scans later"},
      {"sensor_odometry", "nav_msgs/Odometry", "where the rays of the scan start, in the map's frame"},
      {"status", "stillmap/Status", "counts, times and drops, with each scan"},
      {"static_map", cloud, "latched; the centres of the static voxels, intensity = p_static"},
      {"moving_boxes", "visualization_msgs/MarkerArray", "an upright box around each thing that moves"},
      {"explanation", "visualization_msgs/MarkerArray",
       "latched; the last explained place, its words and the scans' rays"},
      {"appeared", cloud, "latched; what ~diff_map finds here and not in the file"},
      {"gone", cloud, "latched; what it finds in the file and not here"},
      {"map", "stillmap/LabelledMap", "latched; every voxel with its log-odds and label"},
      {"octomap", "octomap_msgs/Octomap", "latched; static voxels occupied, dynamic ones free; binary"},
      {"parameter_descriptions", "dynamic_reconfigure/ConfigDescription",
       "latched; the live parameters, for rqt_reconfigure"},
      {"parameter_updates", "dynamic_reconfigure/Config", "latched; their values"},
  };
  return topics;
}

const std::vector<Endpoint>& offered_services() {
  static const std::vector<Endpoint> services = {
      {"save_map", "stillmap/SaveMap", "writes the map to a file; the ending says the format"},
      {"reset", "std_srvs/Trigger", "forgets the map"},
      {"load_map", "stillmap/LoadMap", "a .stillmap takes the place of the present map"},
      {"diff_map", "stillmap/DiffMap", "what appeared and what went since a .stillmap was saved"},
      {"explain_point", "stillmap/ExplainPoint", "why the map says what it says of a place"},
      {"clear_box", "stillmap/ClearBox", "forgets the voxels in a box"},
      {"relabel_box", "stillmap/RelabelBox", "makes the map certain of a label in a box"},
      {"set_parameters", "dynamic_reconfigure/Reconfigure", "changes live parameters"},
  };
  return services;
}

}  // namespace stillmap
