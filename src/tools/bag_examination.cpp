#include "tools/bag_examination.hpp"

#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <set>
#include <stdexcept>

#include "doctor/doctor.hpp"
#include "messages/bag_sequence.hpp"
#include "messages/bounded_message.hpp"
#include "messages/frame_id.hpp"
#include "ros/odometry_presets.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {
namespace {

std::vector<std::string> tf_roots(rosbag::Bag& bag) {
  std::set<std::string> parents, children;
  rosbag::View view(bag, rosbag::TopicQuery(std::vector<std::string>{"/tf", "/tf_static"}));
  for (const rosbag::MessageInstance& message : view) {
    if (message.getDataType() != "tf2_msgs/TFMessage") continue;
    const auto transforms = read_message<tf2_msgs::TFMessage>(message);
    for (const geometry_msgs::TransformStamped& transform : transforms->transforms) {
      parents.insert(without_leading_slash(transform.header.frame_id));
      children.insert(without_leading_slash(transform.child_frame_id));
    }
  }
  std::vector<std::string> roots;
  for (const std::string& frame : parents)
    if (!children.count(frame)) roots.push_back(frame);
  return roots;
}

std::string choose(const TopicCounts& topics, const std::string& wanted, const std::string& option) {
  if (topics.count(wanted)) return wanted;
  if (topics.size() == 1) return topics.begin()->first;
  throw std::runtime_error(wanted + " is not in the bag; choose with " + option + " among " +
                           to_text(topics));
}

}  // namespace

BagContents contents_of(const std::string& file) {
  rosbag::Bag bag;
  open_for_reading(bag, file);
  BagContents contents{topics_of_type(bag, "sensor_msgs/PointCloud2"),
                       topics_of_type(bag, "nav_msgs/Odometry"), tf_roots(bag)};
  if (contents.clouds.empty())
    throw std::runtime_error(file +
                             ": no sensor_msgs/PointCloud2 in the bag; convert the sensor's packets with "
                             "its driver, or record the clouds");
  return contents;
}

std::string preset_for(const BagContents& contents) {
  for (const OdometryPreset& preset : odometry_presets()) {
    NodeParameters node;
    apply_odometry_preset(preset.name, node);
    if (contents.clouds.count(node.cloud_topic) && contents.odometry.count(node.odom_topic))
      return preset.name;
  }
  return "generic";
}

void choose_topics(const BagContents& contents, NodeParameters& node) {
  node.cloud_topic = choose(contents.clouds, node.cloud_topic, "--cloud-topic");
  node.odom_topic = choose(contents.odometry, node.odom_topic, "--odom-topic");
}

BagExamination examine(const std::string& bag, const NodeParameters& node) {
  BagInput input{node.cloud_topic, node.odom_topic, check_node_parameters(node)};
  BagSequence sequence(bag, input);
  Doctor doctor(input.pairing);
  Mapper mapper{Parameters{}};
  BagExamination seen;
  for (const std::string& warning : sequence.warnings()) seen.findings.push_back({"stamps", warning});
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < sequence.size() && !doctor.is_done(); ++k) {
    const Frame frame = sequence.read(k);
    const LabelCounts counts = doctor.scans() < Doctor::kScans
                                   ? count(mapper.process(frame.scan, frame.T_map_sensor))
                                   : LabelCounts{};
    for (const Finding& finding : doctor.add(frame.scan, frame.T_map_sensor, counts))
      seen.findings.push_back(finding);
    if (k > 0) seen.way_m += (frame.T_map_sensor.translation() - last).norm();
    last = frame.T_map_sensor.translation();
  }
  seen.scans = doctor.scans();
  return seen;
}

}  // namespace stillmap
