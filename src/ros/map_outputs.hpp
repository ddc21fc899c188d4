#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <chrono>
#include <string>

#include "stillmap/mapper.hpp"

namespace stillmap {

/// The latched maps, each only when somebody listens, it has changed, and not more often than the period.
class MapOutputs {
 public:
  MapOutputs(ros::NodeHandle private_nh, double period_s);
  void set_period(double period_s);
  /// Between two scans.
  void publish_if_due(const Mapper& mapper, const std::string& frame_id);

 private:
  struct Output {
    ros::Publisher publisher;
    std::uint64_t revision = 0;  ///< of the map that was published last
  };
  using Clock = std::chrono::steady_clock;
  static bool is_due(const Output& output, std::uint64_t revision);

  Output map_, static_map_, octomap_;
  Clock::duration period_;
  Clock::time_point last_;
};

}  // namespace stillmap
