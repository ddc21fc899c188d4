#pragma once

#include <rosbag/bag.h>

#include <cstddef>
#include <map>
#include <string>

namespace stillmap {

/// Throws std::runtime_error naming the file and what to do.
void open_for_reading(rosbag::Bag& bag, const std::string& file);

/// Names and counts of messages.
using TopicCounts = std::map<std::string, std::size_t>;
TopicCounts topics_of_type(rosbag::Bag& bag, const std::string& type);
std::string to_text(const TopicCounts& topics);  ///< "/a (12), /b (3)"

}  // namespace stillmap
