#include "clusters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "for_rows.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// A neighbour of a pixel, ahead of it; the one behind finds it in turn.
struct Step {
  int columns, rows;
};
constexpr std::array<Step, 10> kSteps = {
    {{0, 1}, {0, 2}, {1, -2}, {1, -1}, {1, 0}, {1, 1}, {1, 2}, {2, -1}, {2, 0}, {2, 1}}};

/// The nearest returns of some pixels of a column, one coordinate after the other.
struct Pixels {
  const float *x_m, *y_m, *z_m, *range_m;
};

/// Two returns are one surface; NaN never is.
inline bool together(float dx, float dy, float dz, float nearer_range_m, float reach_per_m) {
  const float reach_m = 0.25F + reach_per_m * nearer_range_m;
  return dx * dx + (dy * dy + dz * dz) <= reach_m * reach_m;
}

/// Sets `bit` in the links of each of n pixels that is one surface with its neighbour.
STILLMAP_VECTOR_CLONES void link(std::size_t n, const Pixels here, const Pixels there, float reach_per_m,
                                 std::uint16_t bit, std::uint16_t* __restrict links) {
  for (std::size_t i = 0; i < n; ++i) {
    const bool linked =
        together(here.x_m[i] - there.x_m[i], here.y_m[i] - there.y_m[i], here.z_m[i] - there.z_m[i],
                 std::min(here.range_m[i], there.range_m[i]), reach_per_m);
    links[i] = static_cast<std::uint16_t>(links[i] | (linked ? bit : 0));
  }
}

}  // namespace

void Clusters::find(const ProjectedScan& scan, SensorGeometry geometry,
                    const std::vector<std::uint8_t>& use) {
  // Pixels a little finer than the beams: each ring has rows of its own, with at most one empty row between
  // two.
  grid_ = SphericalGrid(2.0F * geometry.azimuth_step_rad, 0.75F * geometry.ring_spacing_rad,
                        scan.elevation_min_rad, scan.elevation_max_rad);
  reach_per_m_ = 1.2F * std::max(geometry.ring_spacing_rad, 2.0F * geometry.azimuth_step_rad);
  place_rows(scan, use);
  tbb::parallel_for(
      tbb::blocked_range<int>(0, grid_.columns, 64),
      [this](const tbb::blocked_range<int>& columns) { link_columns(columns.begin(), columns.end()); });
  join_links();
  name_clusters(scan);
}

void Clusters::place_rows(const ProjectedScan& scan, const std::vector<std::uint8_t>& use) {
  pixel_of_row_.resize(scan.size());
  for_rows(scan.size(), [&](std::size_t first, std::size_t last) {
    grid_.pixels(last - first, &scan.azimuth_rad[first], &scan.elevation_rad[first], &pixel_of_row_[first]);
    for (std::size_t row = first; row < last; ++row)
      pixel_of_row_[row] = use[row] != 0 ? pixel_of_row_[row] : -1;
  });
  empty_columns();
  for (std::size_t row = 0; row < scan.size(); ++row) {
    if (pixel_of_row_[row] < 0) continue;
    column_used_[pixel_of_row_[row] / grid_.rows] = 1;
    Return& nearest = nearest_[pixel_of_row_[row]];
    if (scan.range_m[row] < nearest.range_m)
      nearest = {scan.x_m[row], scan.y_m[row], scan.z_m[row], scan.range_m[row],
                 static_cast<std::int32_t>(row)};
  }
}

void Clusters::empty_columns() {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr Return kNoReturn{kNaN, kNaN, kNaN, kInfinity, kNone};
  const auto columns = static_cast<std::size_t>(grid_.columns);
  if (nearest_.size() == grid_.size() && column_used_.size() == columns) {
    for_each_used_pixel([&](std::size_t pixel) { nearest_[pixel] = kNoReturn; });
  } else {
    nearest_.assign(grid_.size(), kNoReturn);
    links_.resize(grid_.size());
    parent_.resize(grid_.size());
    name_.resize(grid_.size());
  }
  column_used_.assign(columns, 0);
}

void Clusters::link_columns(int first, int last) {
  // Three columns one coordinate after the other: this one and the next two.
  const auto rows = static_cast<std::size_t>(grid_.rows);
  std::vector<float> planes(3 * 4 * rows);
  const auto plane = [&](int column, std::size_t coordinate) {
    return &planes[(static_cast<std::size_t>(column % 3) * 4 + coordinate) * rows];
  };
  const auto load = [&](int column) {
    const Return* returns = &nearest_[static_cast<std::size_t>(column % grid_.columns) * rows];
    float *x = plane(column, 0), *y = plane(column, 1), *z = plane(column, 2), *range = plane(column, 3);
    for (std::size_t row = 0; row < rows; ++row) {
      x[row] = returns[row].x_m;
      y[row] = returns[row].y_m;
      z[row] = returns[row].z_m;
      range[row] = returns[row].range_m;
    }
  };
  const auto at = [&](int column, int row) {
    return Pixels{plane(column, 0) + row, plane(column, 1) + row, plane(column, 2) + row,
                  plane(column, 3) + row};
  };
  int loaded = first;
  for (int column = first; column < last; ++column) {
    if (column_used_[column] == 0) continue;
    for (loaded = std::max(loaded, column); loaded <= column + 2; ++loaded) load(loaded);
    std::uint16_t* links = &links_[static_cast<std::size_t>(column) * rows];
    std::fill_n(links, rows, std::uint16_t{0});
    for (std::size_t k = 0; k < kSteps.size(); ++k) {
      const int low = std::max(0, -kSteps[k].rows), high = grid_.rows - std::max(0, kSteps[k].rows);
      if (low < high)
        link(static_cast<std::size_t>(high - low), at(column, low),
             at(column + kSteps[k].columns, low + kSteps[k].rows), reach_per_m_,
             static_cast<std::uint16_t>(1U << k), links + low);
    }
  }
}

inline std::int32_t Clusters::root(std::int32_t pixel) {
  while (parent_[pixel] != pixel) pixel = parent_[pixel] = parent_[parent_[pixel]];
  return pixel;
}

inline void Clusters::join(std::int32_t a, std::int32_t b) {
  if (parent_[a] == parent_[b]) return;
  const std::int32_t root_a = root(a), root_b = root(b), least = std::min(root_a, root_b);
  parent_[root_a] = parent_[root_b] = parent_[a] = parent_[b] = least;
}

void Clusters::join_links() {
  for_each_used_pixel([this](std::size_t pixel) { parent_[pixel] = static_cast<std::int32_t>(pixel); });
  for (int column = 0; column < grid_.columns; ++column) {
    if (column_used_[column] == 0) continue;
    std::array<std::int32_t, kSteps.size()> to;
    for (std::size_t k = 0; k < kSteps.size(); ++k)
      to[k] = (column + kSteps[k].columns) % grid_.columns * grid_.rows + kSteps[k].rows;
    for (int row = 0; row < grid_.rows; ++row)
      for (unsigned links = links_[column * grid_.rows + row]; links != 0; links &= links - 1)
        join(column * grid_.rows + row, to[__builtin_ctz(links)] + row);
  }
  // Those before are roots by now.
  for_each_used_pixel([this](std::size_t pixel) { parent_[pixel] = parent_[parent_[pixel]]; });
}

// A return that the nearest one of its pixel hides, at an edge, goes with what it touches in the pixels
// around.
std::int32_t Clusters::surface_of(const ProjectedScan& scan, std::size_t row) const {
  constexpr int kAround = 2;
  const auto distance_m2 = [&](std::int32_t pixel) {
    const Return& there = nearest_[pixel];
    const float dx = there.x_m - scan.x_m[row], dy = there.y_m - scan.y_m[row],
                dz = there.z_m - scan.z_m[row];
    const bool linked = together(dx, dy, dz, std::min(there.range_m, scan.range_m[row]), reach_per_m_);
    return linked ? dx * dx + (dy * dy + dz * dz) : std::numeric_limits<float>::infinity();
  };
  const std::int32_t own = pixel_of_row_[row];
  if (std::isfinite(distance_m2(own))) return own;
  const int own_column = own / grid_.rows, own_row = own % grid_.rows;
  const int low = std::max(0, own_row - kAround), high = std::min(grid_.rows - 1, own_row + kAround);
  std::int32_t closest = kNone;
  float closest_m2 = std::numeric_limits<float>::infinity();
  for (int column = own_column - kAround; column <= own_column + kAround; ++column)
    for (int r = low; r <= high; ++r) {
      const std::int32_t pixel = (column + grid_.columns) % grid_.columns * grid_.rows + r;
      const float m2 = distance_m2(pixel);
      if (m2 < closest_m2) closest_m2 = m2, closest = pixel;
    }
  return closest;
}

void Clusters::name_clusters(const ProjectedScan& scan) {
  of_row_.resize(scan.size());
  for_rows(scan.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row) {
      of_row_[row] = kNone;
      if (pixel_of_row_[row] < 0) continue;
      const std::int32_t surface = surface_of(scan, row);
      if (surface != kNone) of_row_[row] = parent_[surface];
    }
  });
  for_each_used_pixel([this](std::size_t pixel) { name_[pixel] = kNone; });
  count_ = 0;
  for (std::int32_t& cluster : of_row_) {
    if (cluster == kNone) continue;
    std::int32_t& name = name_[cluster];
    if (name == kNone) name = static_cast<std::int32_t>(count_++);
    cluster = name;
  }
}

}  // namespace stillmap
