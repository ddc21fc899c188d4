#pragma once

#include <memory>
#include <string>
#include <vector>

#include "messages/bag_sequence.hpp"

namespace stillmap {

/// The scans of one or several LiDARs in a bag, in the order of their stamps; Scan::sensor is the LiDAR's
/// place among those given. With several, frames are named by their place in that order.
class LidarsInBag : public Sequence {
 public:
  /// Throws std::runtime_error as BagSequence does.
  LidarsInBag(const std::string& file, const std::vector<BagInput>& lidars);

  std::size_t size() const override { return places_.size(); }
  Frame read(std::size_t index) override;

  /// Where a frame's cloud is in the bag.
  struct Cloud {
    std::string topic;
    std::size_t number;  ///< among all clouds of the topic, in the bag's order
  };
  Cloud cloud_of(std::size_t index) const;
  std::vector<std::string> cloud_topics() const;
  std::vector<std::string> warnings() const;

 private:
  struct Place {
    std::int64_t stamp_ns;
    std::size_t lidar, index;
  };
  std::vector<std::unique_ptr<BagSequence>> lidars_;
  std::vector<Place> places_;
};

}  // namespace stillmap
