#include "messages/bag_topics.hpp"

#include <rosbag/view.h>

#include <stdexcept>

#include "messages/bag_check.hpp"

namespace stillmap {

void open_for_reading(rosbag::Bag& bag, const std::string& file) {
  check_bag(file);
  try {
    bag.open(file, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::runtime_error(file +
                             ": the bag has no index (its recording was cut off); run `rosbag reindex`");
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(file + ": not a readable bag: " + error.what());
  }
}

TopicCounts topics_of_type(rosbag::Bag& bag, const std::string& type) {
  rosbag::View view(bag, rosbag::TypeQuery(type));
  TopicCounts counts;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) counts[connection->topic];
  for (auto& [topic, count] : counts) count = rosbag::View(bag, rosbag::TopicQuery(topic)).size();
  return counts;
}

std::string to_text(const TopicCounts& topics) {
  std::string text;
  for (const auto& [topic, count] : topics)
    text += (text.empty() ? "" : ", ") + topic + " (" + std::to_string(count) + ")";
  return text;
}

}  // namespace stillmap
