#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>

#include "stillmap/types.hpp"

namespace stillmap {

/// One scan of a recorded sequence, with its place.
struct Frame {
  std::string name;  ///< "000012": what its label file is called
  Scan scan;
  Eigen::Isometry3d T_map_sensor = Eigen::Isometry3d::Identity();
};

/// A recorded sequence, read scan by scan.
class Sequence {
 public:
  virtual ~Sequence() = default;
  virtual std::size_t size() const = 0;
  /// Throws std::runtime_error naming the file or topic, what was seen and what to do.
  virtual Frame read(std::size_t index) = 0;
};

}  // namespace stillmap
