#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/sequence.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// What a method says of each row of a scan.
struct PointVerdicts {
  std::vector<Label> label;
  std::vector<float> p_static;      ///< NaN = never judged; empty when the method knows no probability
  std::vector<Reason> reason = {};  ///< empty when the method gives none
};

/// A way to take moving things out of a sequence of scans: add() every scan, finish(), then ask.
class RemovalMethod {
 public:
  virtual ~RemovalMethod() = default;

  /// What the method says of the scan at its own time; nothing when it judges finished maps only.
  virtual std::optional<PointVerdicts> add(const Frame& frame) = 0;
  virtual void finish() = 0;
  /// What the map says of the scan that was added as the k-th: the finished one or, of a method that judges
  /// at once, the map as it is now.
  virtual PointVerdicts map_verdicts(std::size_t k, const Frame& frame) const = 0;

  /// The effective settings, as YAML.
  virtual std::string settings() const = 0;
};

/// Whether a row holds a return.
inline bool is_return(const Eigen::Vector3f& point_sensor_m) {
  return point_sensor_m.allFinite() && !point_sensor_m.isZero(0);
}

}  // namespace stillmap
