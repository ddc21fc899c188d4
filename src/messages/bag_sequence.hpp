#pragma once

#include <rosbag/bag.h>
#include <rosbag/message_instance.h>
#include <rosbag/view.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/sequence.hpp"
#include "messages/pairing_options.hpp"
#include "messages/pose_buffer.hpp"

namespace stillmap {

/// Which topics of a bag to read; an empty name is the bag's only topic of that type.
struct BagInput {
  std::string cloud_topic;
  std::string odom_topic;
  PairingOptions pairing;
  /// Told while the bag is opened, which takes long for a large one.
  std::function<void(std::size_t done, std::size_t clouds)> progress = {};
};

/// The clouds of a bag that have a pose, in the order of their stamps. Opening reads every stamp and pose
/// once; points are read when asked for. Frames are named by the cloud's place in the bag.
class BagSequence : public Sequence {
 public:
  /// Throws std::runtime_error naming the file or topic, what was seen and what to do.
  BagSequence(const std::string& file, const BagInput& input);

  std::size_t size() const override { return entries_.size(); }
  Frame read(std::size_t index) override;

  const std::string& cloud_topic() const { return cloud_topic_; }
  std::int64_t stamp_ns(std::size_t index) const { return entries_.at(index).stamp_ns; }
  /// Place of a frame's cloud among all clouds of the topic, in the bag's order.
  std::size_t cloud_of(std::size_t index) const { return entries_.at(index).cloud; }

  /// One line for each kind of message that was left out; empty when none was.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct Entry {
    std::int64_t stamp_ns;
    std::size_t cloud;  ///< place in the bag
    Eigen::Isometry3d T_map_body;
  };
  /// What it throws gets the file's name.
  template <class Read>
  auto named(Read&& read) const;
  PoseBuffer read_poses(const std::string& topic);
  void pair_clouds(const BagInput& input, const PoseBuffer& poses);

  std::string file_, cloud_topic_;
  PairingOptions pairing_;
  rosbag::Bag bag_;
  std::unique_ptr<rosbag::View> cloud_view_;  ///< what clouds_ point into
  std::vector<rosbag::MessageInstance> clouds_;
  std::vector<Entry> entries_;
  std::vector<std::string> warnings_;
};

}  // namespace stillmap
