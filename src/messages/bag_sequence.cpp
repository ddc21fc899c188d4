#include "messages/bag_sequence.hpp"

#include <nav_msgs/Odometry.h>
#include <ros/serialization.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "messages/bag_topics.hpp"
#include "messages/bounded_message.hpp"
#include "messages/scan_pairing.hpp"

namespace stillmap {
namespace {

/// The topic asked for, or the only one of the type.
std::string choose_topic(rosbag::Bag& bag, const std::string& asked, const std::string& type,
                         const std::string& option) {
  const auto topics = topics_of_type(bag, type);
  const std::string in_bag = bag.getFileName() + ": ";
  if (topics.empty()) throw std::runtime_error(in_bag + "no topic of type " + type + " in the bag");
  if (!asked.empty()) {
    if (topics.count(asked)) return asked;
    throw std::runtime_error(in_bag + "no topic " + asked + " of type " + type + "; there is " +
                             to_text(topics));
  }
  if (topics.size() == 1) return topics.begin()->first;
  throw std::runtime_error(in_bag + "several topics of type " + type + ": " + to_text(topics) +
                           "; choose one with " + option);
}

/// The stamp alone: the header comes first in the message.
std::int64_t stamp_ns_of(const rosbag::MessageInstance& message, std::vector<std::uint8_t>& buffer) {
  buffer.resize(message.size());
  ros::serialization::OStream out(buffer.data(), message.size());
  message.write(out);
  ros::serialization::IStream in(buffer.data(), message.size());
  std_msgs::Header header;
  ros::serialization::deserialize(in, header);  // no arrays in it
  return static_cast<std::int64_t>(header.stamp.toNSec());
}

std::string name_of(std::size_t cloud) {
  char name[24];
  std::snprintf(name, sizeof(name), "%06zu", cloud);
  return name;
}

}  // namespace

BagSequence::BagSequence(const std::string& file, const BagInput& input)
    : file_(file), pairing_(input.pairing) {
  open_for_reading(bag_, file);
  cloud_topic_ = choose_topic(bag_, input.cloud_topic, "sensor_msgs/PointCloud2", "--cloud-topic");
  const std::string odom_topic = choose_topic(bag_, input.odom_topic, "nav_msgs/Odometry", "--odom-topic");
  pair_clouds(input, read_poses(odom_topic));
}

template <class Read>
auto BagSequence::named(Read&& read) const {
  try {
    return read();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file_ + ": " + error.what());
  }
}

PoseBuffer BagSequence::read_poses(const std::string& topic) {
  PoseBuffer poses(pairing_.max_gap_s);
  std::size_t refused = 0;
  std::string why;
  rosbag::View view(bag_, rosbag::TopicQuery(topic));
  for (const rosbag::MessageInstance& message : view) {
    const auto odometry = named([&] { return read_message<nav_msgs::Odometry>(message); });
    try {
      poses.add(static_cast<std::int64_t>(odometry->header.stamp.toNSec()), to_pose(*odometry));
    } catch (const std::invalid_argument& error) {
      ++refused;
      why = error.what();
    }
  }
  if (refused > 0) warnings_.push_back(topic + ": " + std::to_string(refused) + " poses left out: " + why);
  return poses;
}

void BagSequence::pair_clouds(const BagInput& input, const PoseBuffer& poses) {
  const std::string& topic = cloud_topic_;
  cloud_view_ = std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(topic));
  std::map<std::int64_t, std::size_t> cloud_at;
  std::vector<std::uint8_t> buffer;
  for (const rosbag::MessageInstance& message : *cloud_view_) {
    cloud_at.emplace(named([&] { return stamp_ns_of(message, buffer); }), clouds_.size());
    clouds_.push_back(message);
    if (input.progress) input.progress(clouds_.size(), cloud_view_->size());
  }
  if (cloud_at.size() < clouds_.size())
    warnings_.push_back(topic + ": " + std::to_string(clouds_.size() - cloud_at.size()) +
                        " clouds left out: their stamp is that of another one");

  std::string why;
  for (const auto& [stamp_ns, cloud] : cloud_at) {
    const PoseAnswer answer = poses.at(stamp_ns);
    if (answer.kind == PoseAnswer::Kind::kFound)
      entries_.push_back({stamp_ns, cloud, answer.T_map_body});
    else if (why.empty())
      why = answer.why;
  }
  const std::size_t without_pose = cloud_at.size() - entries_.size();
  if (without_pose == 0) return;
  const std::string text = topic + ": " + std::to_string(without_pose) + " of " +
                           std::to_string(cloud_at.size()) + " clouds have no pose: " + why;
  if (entries_.empty())
    throw std::runtime_error(file_ + ": " + text +
                             "; is it the odometry of this sensor, with the same clock?");
  warnings_.push_back(text);
}

Frame BagSequence::read(std::size_t index) {
  const Entry& entry = entries_.at(index);
  const rosbag::MessageInstance& message = clouds_[entry.cloud];
  try {
    const sensor_msgs::PointCloud2ConstPtr cloud = read_message<sensor_msgs::PointCloud2>(message);
    PairedScan paired = to_paired_scan(cloud, entry.T_map_body, pairing_);
    paired.scan.stamp_ns = entry.stamp_ns;
    return {name_of(entry.cloud), std::move(paired.scan), paired.T_map_sensor};
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file_ + ": " + message.getTopic() + ", cloud " + std::to_string(entry.cloud) +
                             ": " + error.what());
  }
}

}  // namespace stillmap
