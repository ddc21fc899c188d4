#include "ros/lidar_places.hpp"

#include <sstream>
#include <stdexcept>

#include "messages/pairing_options.hpp"

namespace stillmap {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    if (part.find_first_not_of(' ') != std::string::npos) parts.push_back(part);
  return parts;
}

}  // namespace

std::vector<LidarPlace> lidar_places(const NodeParameters& parameters) {
  const std::vector<std::string> topics = split(parameters.cloud_topic, ' ');
  const std::vector<std::string> places = split(parameters.sensor_on_body, ';');
  if (topics.empty()) throw std::invalid_argument("cloud_topic: empty; name the scans' topic");
  // tf2 alone says where each LiDAR is.
  const bool from_tf = parameters.odom_topic.empty() && parameters.body_frame.empty();
  if (places.size() != topics.size() && !(from_tf && places.size() == 1))
    throw std::invalid_argument("sensor_on_body: " + std::to_string(places.size()) + " places for " +
                                std::to_string(topics.size()) +
                                " topics of cloud_topic; give one for each, with ; between");
  std::vector<LidarPlace> lidars;
  for (std::size_t i = 0; i < topics.size(); ++i) {
    for (const LidarPlace& other : lidars)
      if (other.topic == topics[i])
        throw std::invalid_argument("cloud_topic: " + topics[i] +
                                    " is named twice; name each LiDAR's topic once");
    lidars.push_back({topics[i], parse_sensor_on_body(places.size() == 1 ? places[0] : places[i])});
  }
  return lidars;
}

}  // namespace stillmap
