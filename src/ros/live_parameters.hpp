#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ros/parameter_server.hpp"

namespace stillmap {

/// The parameters that may change while the node runs, for rqt_reconfigure and other clients of
/// dynamic_reconfigure. Their ranges and meanings are those of the lists of parameters.
class LiveParameters {
 public:
  LiveParameters(ros::NodeHandle private_nh, const NodeSettings& settings);

  /// Takes over what has been asked for since the last call; false when nothing was. For the worker.
  bool update(NodeSettings& settings);

 private:
  struct Live {
    std::string name, help;
    double min, max, value;
  };
  enum class Which { kMin, kMax, kValue };
  dynamic_reconfigure::Config config(Which which) const;
  void describe();
  bool on_set(dynamic_reconfigure::Reconfigure::Request& request,
              dynamic_reconfigure::Reconfigure::Response& response);
  void set(const std::string& name, double value);

  ros::NodeHandle private_nh_;
  std::mutex mutex_;  ///< of the two below
  std::vector<Live> live_;
  bool has_changed_ = false;
  ros::Publisher descriptions_, updates_;
  ros::ServiceServer set_parameters_;
};

}  // namespace stillmap
