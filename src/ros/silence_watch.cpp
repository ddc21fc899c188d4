#include "ros/silence_watch.hpp"

#include <XmlRpcValue.h>
#include <ros/this_node.h>

#include <algorithm>

namespace stillmap {

ros::master::V_TopicInfo published_topics_now() {
  XmlRpc::XmlRpcValue request, response, topics;
  request[0] = ros::this_node::getName();
  request[1] = "";
  ros::master::V_TopicInfo published;
  if (!ros::master::execute("getPublishedTopics", request, response, topics, false)) return published;
  for (int i = 0; i < topics.size(); ++i)
    published.emplace_back(static_cast<std::string>(topics[i][0]), static_cast<std::string>(topics[i][1]));
  return published;
}

std::string why_silent(const ListenedTopic& topic, std::size_t publishers,
                       const ros::master::V_TopicInfo& published, const std::string& own_prefix) {
  std::string others;
  for (const ros::master::TopicInfo& info : published) {
    if (info.name == topic.name && info.datatype != topic.type)
      return "it is a " + info.datatype + ", not a " + topic.type + "; set " + topic.parameter +
             " to another topic";
    const bool is_own = info.name.compare(0, own_prefix.size(), own_prefix) == 0;
    if (info.name != topic.name && info.datatype == topic.type && !is_own) others += " " + info.name;
  }
  const std::string seen =
      others.empty() ? "there is no other " + topic.type : topic.type + " are on" + others;
  if (publishers > 0)
    return "it has a publisher, which is silent; " + seen +
           "; see whether the publisher or the recording stands still, or set " + topic.parameter;
  return "nobody publishes it; " + seen +
         (others.empty() ? "; start the publisher or the recording, or set " : "; set ") + topic.parameter;
}

void SilenceWatch::heard(Clock::time_point now) {
  last_ = now;
  next_ = kFirst;
}

std::optional<std::chrono::seconds> SilenceWatch::due(Clock::time_point now) {
  const auto silence = std::chrono::duration_cast<std::chrono::seconds>(now - last_);
  if (silence < next_) return std::nullopt;
  next_ = std::max(2 * next_, silence + kFirst);
  return silence;
}

}  // namespace stillmap
