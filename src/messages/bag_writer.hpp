#pragma once

#include <rosbag/bag.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/sequence.hpp"

namespace stillmap {

/// Names in a bag, and the frame of its clouds; the default is what FAST-LIO publishes.
struct BagTopics {
  std::string cloud = "/cloud_registered";
  std::string odometry = "/Odometry";
  std::string tf = "/tf";
  std::string world_frame_id = "camera_init";
  std::string sensor_frame_id = "body";
  bool world_clouds = true;  ///< points in the world frame; else in the sensor's
};

/// What a scan's points have beside their place; an empty list leaves the field out.
struct PointFields {
  std::vector<float> intensity;
  std::vector<std::uint16_t> ring;
  std::vector<std::uint32_t> label;
};

/// Records a sequence as an odometry package would publish it: cloud, pose and transform of one stamp. ROS
/// has no time before 1970 and none at 0, so the stamps are those of the frames plus kBagEpoch_s.
class BagWriter {
 public:
  static constexpr std::uint32_t kBagEpoch_s = 1'600'000'000;

  /// Throws std::runtime_error when the file cannot be created.
  explicit BagWriter(const std::string& file, const BagTopics& topics = {});

  /// Throws std::invalid_argument when a field has another size than the scan.
  void write(const Frame& frame, const PointFields& fields);

 private:
  BagTopics topics_;
  rosbag::Bag bag_;
};

}  // namespace stillmap
