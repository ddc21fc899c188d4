#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace stillmap {

/// Warnings that would repeat at the sensor's rate: each kind at most once in five seconds of wall time, with
/// the number of those held back. Safe to call from several threads.
class ThrottledLog {
 public:
  void warn(const std::string& kind, const std::string& text);

 private:
  struct Kind {
    std::chrono::steady_clock::time_point last;
    unsigned held_back = 0;
  };
  std::mutex mutex_;
  std::map<std::string, Kind> kinds_;
};

}  // namespace stillmap
