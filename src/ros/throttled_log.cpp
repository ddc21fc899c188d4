#include "ros/throttled_log.hpp"

#include <ros/console.h>

namespace stillmap {

void ThrottledLog::warn(const std::string& kind, const std::string& text) {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  const auto [entry, is_first] = kinds_.try_emplace(kind);
  Kind& state = entry->second;
  if (!is_first && now - state.last < std::chrono::seconds(5)) {
    ++state.held_back;
    return;
  }
  if (state.held_back > 0)
    ROS_WARN_STREAM(text << " (and " << state.held_back << " more like this)");
  else
    ROS_WARN_STREAM(text);
  state = {now, 0};
}

}  // namespace stillmap
