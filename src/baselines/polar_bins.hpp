#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

namespace stillmap {

/// The egocentric bins of ERASOR: rings and sectors around the sensor, with the height span of what is in
/// each (its pseudo occupancy).
class PolarBins {
 public:
  struct Layout {
    int rings, sectors;
    double max_range_m;
    double min_z_m, max_z_m;  ///< relative to the sensor, axes of the map

    int bin_count() const { return rings * sectors; }
    /// -1 outside of the volume of interest.
    int bin_of(const Eigen::Vector3d& upright) const;
  };
  struct Bin {
    double lowest_m = std::numeric_limits<double>::max();
    double highest_m = std::numeric_limits<double>::lowest();
    std::vector<std::uint32_t> members;
    double span_m() const { return highest_m - lowest_m; }
  };

  explicit PolarBins(const Layout& layout)
      : layout_(layout), bins_(static_cast<std::size_t>(layout.bin_count())) {}

  /// `upright` is relative to the sensor, axes of the map.
  void add(const Eigen::Vector3d& upright, std::uint32_t member);
  const std::vector<Bin>& bins() const { return bins_; }

 private:
  Layout layout_;
  std::vector<Bin> bins_;
};

/// Height of the ground below the sensor, relative to it: the median over small cells around it of the lowest
/// return.
double ground_below_m(const std::vector<Eigen::Vector3d>& upright_returns);

}  // namespace stillmap
