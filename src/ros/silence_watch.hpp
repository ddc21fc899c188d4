#pragma once

#include <ros/master.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace stillmap {

/// A topic that the node listens to, for the words of its warnings.
struct ListenedTopic {
  std::string name, type;  ///< as the master has them: /cloud_registered, sensor_msgs/PointCloud2
  std::string parameter;   ///< that says the name
};

/// ros::master::getTopics() without its waiting for a master that has gone: the scans must go on.
ros::master::V_TopicInfo published_topics_now();

/// What is wrong with a topic on which nothing comes, and what to do. `published` is what the master knows;
/// topics below `own_prefix` are the node's outputs, which are no advice.
std::string why_silent(const ListenedTopic& topic, std::size_t publishers,
                       const ros::master::V_TopicInfo& published, const std::string& own_prefix);

/// Says when to warn of a topic's silence: after five seconds, then whenever the silence has doubled.
class SilenceWatch {
 public:
  using Clock = std::chrono::steady_clock;
  explicit SilenceWatch(Clock::time_point start) : last_(start) {}
  void heard(Clock::time_point now);
  /// The silence so far, in whole seconds, when it is time to warn of it.
  std::optional<std::chrono::seconds> due(Clock::time_point now);

 private:
  static constexpr std::chrono::seconds kFirst{5};
  Clock::time_point last_;
  std::chrono::seconds next_ = kFirst;
};

}  // namespace stillmap
