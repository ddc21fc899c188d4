#pragma once

#include <cstdint>
#include <vector>

#include "stillmap/range_image.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// Connected pieces of the surface in one scan, found on its image: two returns belong together when their
/// pixels are neighbours and they lie closer than the beams' spacing there explains.
class Clusters {
 public:
  static constexpr std::int32_t kNone = -1;

  /// Rows with use[row] == 0 take no part.
  void find(const Scan& scan, const ProjectedScan& projected, SensorGeometry geometry,
            const std::vector<std::uint8_t>& use);

  /// Cluster of each row, 0 .. count() - 1, or kNone.
  const std::vector<std::int32_t>& of_row() const { return of_row_; }
  std::size_t count() const { return count_; }

 private:
  void place_rows(const ProjectedScan& projected, const std::vector<std::uint8_t>& use);
  void connect(const Scan& scan, const ProjectedScan& projected, SensorGeometry geometry);
  void name_clusters(const Scan& scan, const ProjectedScan& projected, SensorGeometry geometry,
                     const std::vector<std::uint8_t>& use);
  bool together(const Scan& scan, const ProjectedScan& projected, SensorGeometry geometry, std::int32_t a,
                std::int32_t b) const;
  std::int32_t root(std::int32_t pixel);
  void join(std::int32_t a, std::int32_t b);

  SphericalGrid grid_;
  std::vector<std::int32_t> nearest_row_;  ///< of each pixel, or kNone
  std::vector<std::int32_t> parent_;       ///< union-find over pixels
  std::vector<std::int32_t> of_row_;
  std::size_t count_ = 0;
};

}  // namespace stillmap
