#include "messages/lidars_in_bag.hpp"

#include <algorithm>
#include <cstdio>
#include <tuple>

namespace stillmap {

LidarsInBag::LidarsInBag(const std::string& file, const std::vector<BagInput>& lidars) {
  for (const BagInput& input : lidars) {
    lidars_.push_back(std::make_unique<BagSequence>(file, input));
    for (std::size_t index = 0; index < lidars_.back()->size(); ++index)
      places_.push_back({lidars_.back()->stamp_ns(index), lidars_.size() - 1, index});
  }
  std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
    return std::tie(a.stamp_ns, a.lidar) < std::tie(b.stamp_ns, b.lidar);
  });
}

Frame LidarsInBag::read(std::size_t index) {
  const Place& place = places_.at(index);
  Frame frame = lidars_[place.lidar]->read(place.index);
  frame.scan.sensor = static_cast<int>(place.lidar);
  if (lidars_.size() == 1) return frame;
  char name[24];
  std::snprintf(name, sizeof(name), "%06zu", index);
  frame.name = name;
  return frame;
}

LidarsInBag::Cloud LidarsInBag::cloud_of(std::size_t index) const {
  const Place& place = places_.at(index);
  const BagSequence& lidar = *lidars_[place.lidar];
  return {lidar.cloud_topic(), lidar.cloud_of(place.index)};
}

std::vector<std::string> LidarsInBag::cloud_topics() const {
  std::vector<std::string> topics;
  for (const auto& lidar : lidars_) topics.push_back(lidar->cloud_topic());
  return topics;
}

std::vector<std::string> LidarsInBag::warnings() const {
  std::vector<std::string> warnings;
  for (const auto& lidar : lidars_)
    for (const std::string& warning : lidar->warnings())
      if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(warning);
  return warnings;
}

}  // namespace stillmap
