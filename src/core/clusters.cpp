#include "clusters.hpp"

#include <algorithm>

namespace stillmap {

void Clusters::find(const Scan& scan, const ProjectedScan& projected, SensorGeometry geometry,
                    const std::vector<std::uint8_t>& use) {
  // Pixels a little finer than the beams: each ring has rows of its own, with at most one empty row between
  // two.
  grid_ = SphericalGrid(2.0F * geometry.azimuth_step_rad, 0.75F * geometry.ring_spacing_rad,
                        projected.elevation_min_rad, projected.elevation_max_rad);
  place_rows(projected, use);
  connect(scan, projected, geometry);
  name_clusters(scan, projected, geometry, use);
}

void Clusters::place_rows(const ProjectedScan& projected, const std::vector<std::uint8_t>& use) {
  nearest_row_.assign(grid_.size(), kNone);
  for (std::size_t row = 0; row < projected.size(); ++row) {
    if (use[row] == 0) continue;
    const int pixel = grid_.pixel(projected.azimuth_rad[row], projected.elevation_rad[row]);
    if (pixel < 0) continue;
    std::int32_t& nearest = nearest_row_[pixel];
    if (nearest == kNone || projected.range_m[row] < projected.range_m[nearest])
      nearest = static_cast<std::int32_t>(row);
  }
}

bool Clusters::together(const Scan& scan, const ProjectedScan& projected, SensorGeometry geometry,
                        std::int32_t a, std::int32_t b) const {
  const float range_m = std::min(projected.range_m[a], projected.range_m[b]);
  const float spacing_rad = std::max(geometry.ring_spacing_rad, 2.0F * geometry.azimuth_step_rad);
  const float reach_m = 0.25F + 1.2F * spacing_rad * range_m;
  return (scan.points[a] - scan.points[b]).squaredNorm() <= reach_m * reach_m;
}

void Clusters::connect(const Scan& scan, const ProjectedScan& projected, SensorGeometry geometry) {
  parent_.resize(grid_.size());
  for (std::size_t pixel = 0; pixel < parent_.size(); ++pixel)
    parent_[pixel] = static_cast<std::int32_t>(pixel);
  const auto connect_to = [&](std::int32_t pixel, int column, int row) {
    if (row < 0 || row >= grid_.rows) return;
    const std::int32_t other = (column % grid_.columns) * grid_.rows + row;
    const std::int32_t a = nearest_row_[pixel], b = nearest_row_[other];
    if (b != kNone && together(scan, projected, geometry, a, b)) join(pixel, other);
  };
  for (int column = 0; column < grid_.columns; ++column)
    for (int row = 0; row < grid_.rows; ++row) {
      const std::int32_t pixel = column * grid_.rows + row;
      if (nearest_row_[pixel] == kNone) continue;
      connect_to(pixel, column, row + 1);
      connect_to(pixel, column, row + 2);
      for (int up = -2; up <= 2; ++up) connect_to(pixel, column + 1, row + up);
      for (int up = -1; up <= 1; ++up) connect_to(pixel, column + 2, row + up);
    }
}

void Clusters::name_clusters(const Scan& scan, const ProjectedScan& projected, SensorGeometry geometry,
                             const std::vector<std::uint8_t>& use) {
  std::vector<std::int32_t> name(grid_.size(), kNone);
  of_row_.assign(projected.size(), kNone);
  count_ = 0;
  for (std::size_t row = 0; row < projected.size(); ++row) {
    if (use[row] == 0) continue;
    const int pixel = grid_.pixel(projected.azimuth_rad[row], projected.elevation_rad[row]);
    if (pixel < 0) continue;
    const auto here = static_cast<std::int32_t>(row);
    if (!together(scan, projected, geometry, nearest_row_[pixel], here)) continue;
    std::int32_t& cluster = name[root(pixel)];
    if (cluster == kNone) cluster = static_cast<std::int32_t>(count_++);
    of_row_[row] = cluster;
  }
}

std::int32_t Clusters::root(std::int32_t pixel) {
  while (parent_[pixel] != pixel) pixel = parent_[pixel] = parent_[parent_[pixel]];
  return pixel;
}

void Clusters::join(std::int32_t a, std::int32_t b) {
  a = root(a);
  b = root(b);
  parent_[std::max(a, b)] = std::min(a, b);
}

}  // namespace stillmap
