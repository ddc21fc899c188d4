// The message types from arbitrary bytes.

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>
#include <stillmap/LabelledMap.h>
#include <stillmap/SaveMap.h>
#include <stillmap/Status.h>
#include <tf2_msgs/TFMessage.h>

#include "expect.hpp"
#include "input.hpp"
#include "messages/bounded_message.hpp"
#include "messages/octomap_message.hpp"
#include "messages/point_cloud_conversion.hpp"
#include "messages/scan_pairing.hpp"

namespace stillmap::fuzz {
namespace {

template <class Message>
Message read(Input& in) {
  const std::string all = in.take_all();
  std::vector<std::uint8_t> bytes(all.begin(), all.end());
  Message message;
  deserialize_bounded(bytes, message);
  expect(ros::serialization::serializationLength(message) <= bytes.size(),
         "a message is what its bytes hold");
  return message;
}

void read_some_type(Input& in) {
  switch (in.choose(7)) {
    case 0: {
      Scan scan;
      return to_scan(read<sensor_msgs::PointCloud2>(in), scan);
    }
    case 1:
      return expect(to_pose(read<nav_msgs::Odometry>(in)).matrix().allFinite(), "a pose is finite");
    case 2:
      read<tf2_msgs::TFMessage>(in);
      return;
    case 3:
      read<LabelledMap>(in);
      return;
    case 4:
      read<Status>(in);
      return;
    case 5:
      read<SaveMapRequest>(in);
      return;
    default:
      read<OctomapMessage>(in);
  }
}

}  // namespace
}  // namespace stillmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stillmap::fuzz;
  Input in(data, size);
  expect_named_refusal("", [&] { read_some_type(in); });
  return 0;
}
