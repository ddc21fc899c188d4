#include "tools/open_bag.hpp"

#include "tools/say.hpp"

namespace stillmap {

std::unique_ptr<BagSequence> open_bag(const SequenceOptions& options) {
  BagInput input;
  input.cloud_topic = options.cloud_topic;
  input.odom_topic = options.odom_topic;
  input.pairing.cloud_frame = parse_cloud_frame(options.cloud_frame);
  input.pairing.T_body_sensor = parse_sensor_on_body(options.sensor_on_body);
  auto sequence = std::make_unique<BagSequence>(options.path, input);
  for (const std::string& warning : sequence->warnings()) say(warning);
  return sequence;
}

}  // namespace stillmap
