#include "ros/map_outputs.hpp"

#include "messages/map_messages.hpp"

namespace stillmap {

MapOutputs::MapOutputs(ros::NodeHandle private_nh, double period_s) {
  set_period(period_s);
  const bool latch = true;
  map_.publisher = private_nh.advertise<LabelledMap>("map", 1, latch);
  static_map_.publisher = private_nh.advertise<sensor_msgs::PointCloud2>("static_map", 1, latch);
  octomap_.publisher = private_nh.advertise<OctomapMessage>("octomap", 1, latch);
}

void MapOutputs::set_period(double period_s) {
  period_ = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(period_s));
}

bool MapOutputs::is_due(const Output& output, std::uint64_t revision) {
  return output.revision != revision && output.publisher.getNumSubscribers() > 0;
}

void MapOutputs::publish_if_due(const Mapper& mapper, const std::string& frame_id) {
  const std::uint64_t revision = mapper.revision();
  const auto due = [&](const Output& output) { return is_due(output, revision); };
  if (!due(map_) && !due(static_map_) && !due(octomap_)) return;
  if (Clock::now() - last_ < period_) return;
  last_ = Clock::now();
  const MapSnapshotPtr map = mapper.snapshot();
  const auto publish = [&](Output& output, auto to_message) {
    if (!due(output)) return;
    output.publisher.publish(to_message(*map, frame_id));
    output.revision = revision;
  };
  publish(map_, to_labelled_map);
  publish(static_map_, to_static_cloud);
  publish(octomap_, to_octomap_message);
}

}  // namespace stillmap
