#include "tools/open_bag.hpp"

#include "ros/lidar_places.hpp"
#include "tools/progress_bar.hpp"
#include "tools/say.hpp"

namespace stillmap {
namespace {

/// One for each topic; an empty topic is the bag's only one.
std::vector<LidarPlace> lidars_of(const SequenceOptions& options) {
  if (options.cloud_topic.empty()) return {{"", parse_sensor_on_body(options.sensor_on_body)}};
  NodeParameters node;
  node.cloud_topic = options.cloud_topic;
  node.sensor_on_body = options.sensor_on_body;
  return lidar_places(node);
}

}  // namespace

std::unique_ptr<LidarsInBag> open_bag(const SequenceOptions& options) {
  std::unique_ptr<ProgressBar> bar;
  std::vector<BagInput> inputs;
  for (const LidarPlace& lidar : lidars_of(options)) {
    BagInput input;
    input.cloud_topic = lidar.topic;
    input.odom_topic = options.odom_topic;
    input.pairing.cloud_frame = parse_cloud_frame(options.cloud_frame);
    input.pairing.T_body_sensor = lidar.T_body_sensor;
    input.progress = [&bar](std::size_t done, std::size_t clouds) {
      if (done == 1) bar.reset();
      if (!bar) bar = std::make_unique<ProgressBar>("reading stamps", clouds);
      bar->advance();
    };
    inputs.push_back(input);
  }
  auto sequence = std::make_unique<LidarsInBag>(options.path, inputs);
  bar.reset();
  for (const std::string& warning : sequence->warnings()) say(warning);
  return sequence;
}

}  // namespace stillmap
