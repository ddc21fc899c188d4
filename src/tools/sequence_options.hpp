#pragma once

#include <memory>
#include <string>

#include "io/sequence.hpp"

namespace CLI {
class App;
}

namespace stillmap {

/// The options by which a command takes a recorded sequence: a folder or a bag.
struct SequenceOptions {
  std::string path;
  std::string cloud_topic;  ///< empty = the bag's only one
  std::string odom_topic;   ///< empty = the bag's only one
  std::string cloud_frame = "world";
  std::string sensor_on_body = "0 0 0 0 0 0 1";

  void add_to(CLI::App& command);
  void add_bag_options_to(CLI::App& command);  ///< without the path
  std::unique_ptr<Sequence> open() const;
};

}  // namespace stillmap
