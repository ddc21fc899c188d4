#include "clusters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "cluster_links.hpp"
#include "for_rows.hpp"

namespace stillmap {
inline float Clusters::range_of(Nearest nearest) {
  const auto bits = static_cast<std::uint32_t>(nearest >> 32);
  float range_m;
  std::memcpy(&range_m, &bits, sizeof range_m);
  return range_m;
}

inline Clusters::Nearest Clusters::nearest(float range_m, std::uint32_t row) {
  std::uint32_t bits;  // of positive numbers they are in their order
  std::memcpy(&bits, &range_m, sizeof bits);
  return Nearest{bits} << 32 | row;
}

void Clusters::find(const ProjectedScan& scan, SensorGeometry geometry,
                    const std::vector<std::uint32_t>& rows) {
  // Pixels a little finer than the beams: each ring has rows of its own, with at most one empty row between
  // two.
  grid_ = SphericalGrid(2.0F * geometry.azimuth_step_rad, 0.75F * geometry.ring_spacing_rad,
                        scan.elevation_min_rad, scan.elevation_max_rad);
  reach_per_m_ = 1.2F * std::max(geometry.ring_spacing_rad, 2.0F * geometry.azimuth_step_rad);
  place_rows(scan, rows);
  roots_.resize(static_cast<std::size_t>((grid_.columns + kStripe - 1) / kStripe));
  for_each_index(roots_.size(), [&](std::size_t stripe) {
    const int first = static_cast<int>(stripe) * kStripe, last = std::min(first + kStripe, grid_.columns);
    link_columns(scan, first, last);
    join_stripe(first, last, roots_[stripe]);
  });
  join_stripes();
  name_clusters(scan, rows);
}

void Clusters::place_rows(const ProjectedScan& scan, const std::vector<std::uint32_t>& rows) {
  pixel_.resize(rows.size());
  column_.resize(rows.size());
  for_rows(rows.size(), [&](std::size_t first, std::size_t last) {
    constexpr std::size_t kAtOnce = 512;
    float azimuth_rad[kAtOnce], elevation_rad[kAtOnce];
    for (; first < last; first += kAtOnce) {
      const std::size_t n = std::min(kAtOnce, last - first);
      for (std::size_t i = 0; i < n; ++i) {
        azimuth_rad[i] = scan.azimuth_rad[rows[first + i]];
        elevation_rad[i] = scan.elevation_rad[rows[first + i]];
      }
      grid_.pixels(n, azimuth_rad, elevation_rad, &pixel_[first]);
      for (std::size_t i = 0; i < n; ++i) column_[first + i] = grid_.column(azimuth_rad[i]);
    }
  });
  empty_columns();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Span& used = used_[column_[i]];
    const int row = pixel_[i] - column_[i] * grid_.rows;
    used = {std::min(used.low, row), std::max(used.high, row + 1)};
    Nearest& there = nearest_[pixel_[i]];
    there = std::min(there, nearest(scan.range_m[rows[i]], rows[i]));
  }
}

void Clusters::empty_columns() {
  const auto columns = static_cast<std::size_t>(grid_.columns), rows = static_cast<std::size_t>(grid_.rows);
  if (nearest_.size() == grid_.size() && used_.size() == columns) {
    for (std::size_t column = 0; column < columns; ++column)
      for (int row = used_[column].low; row < used_[column].high; ++row)
        nearest_[column * rows + static_cast<std::size_t>(row)] = kNothing;
  } else {
    nearest_.assign(grid_.size(), kNothing);
    links_.resize(grid_.size());
    parent_.resize(grid_.size());
    name_.resize(grid_.size());
  }
  used_.assign(columns, Span{grid_.rows, 0});
}

void Clusters::link_columns(const ProjectedScan& scan, int first, int last) {
  // Three columns one coordinate after the other: this one and the next two.
  const auto rows = static_cast<std::size_t>(grid_.rows);
  std::vector<float> planes(3 * 4 * rows);
  const auto plane = [&](int column, std::size_t coordinate) {
    return &planes[(static_cast<std::size_t>(column % 3) * 4 + coordinate) * rows];
  };
  const auto load = [&](int column) {
    // As far as it is looked at from the columns before.
    Span looked_at{grid_.rows, 0};
    for (int before = std::max(first, column - 2); before <= column && before < last; ++before)
      if (!used_[before].empty())
        looked_at = {std::min(looked_at.low, used_[before].low - 2),
                     std::max(looked_at.high, used_[before].high + 2)};
    load_column(scan, column % grid_.columns, looked_at,
                {plane(column, 0), plane(column, 1), plane(column, 2), plane(column, 3)});
  };
  const auto at = [&](int column, int row) {
    return PixelReturns{plane(column, 0) + row, plane(column, 1) + row, plane(column, 2) + row,
                        plane(column, 3) + row};
  };
  int loaded = first;
  for (int column = first; column < last; ++column) {
    const Span used = used_[column];
    if (used.empty()) continue;
    for (loaded = std::max(loaded, column); loaded <= column + 2; ++loaded) load(loaded);
    std::uint16_t* links = &links_[static_cast<std::size_t>(column) * rows];
    std::fill(links + used.low, links + used.high, std::uint16_t{0});
    for (std::size_t k = 0; k < kPixelSteps.size(); ++k) {
      const int low = std::max(used.low, -kPixelSteps[k].rows);
      const int high = std::min(used.high, grid_.rows - std::max(0, kPixelSteps[k].rows));
      if (low < high)
        link_pixels(static_cast<std::size_t>(high - low), at(column, low),
                    at(column + kPixelSteps[k].columns, low + kPixelSteps[k].rows), reach_per_m_,
                    static_cast<std::uint16_t>(1U << k), links + low);
    }
  }
}

void Clusters::load_column(const ProjectedScan& scan, int column, Span span,
                           const std::array<float*, 4>& planes) const {
  const Nearest* nearest = &nearest_[static_cast<std::size_t>(column) * static_cast<std::size_t>(grid_.rows)];
  for (int row = std::max(0, span.low); row < std::min(grid_.rows, span.high); ++row) {
    const bool any = nearest[row] != kNothing;
    const std::int32_t from = any ? row_of(nearest[row]) : 0;
    planes[0][row] = any ? scan.x_m[from] : std::numeric_limits<float>::quiet_NaN();
    planes[1][row] = scan.y_m[from];
    planes[2][row] = scan.z_m[from];
    planes[3][row] = range_of(nearest[row]);
  }
}

// Returns of one pixel, wherever in it: most lie so close by their ranges that they need not be looked at.
inline bool Clusters::share_a_surface(float nearer_m, float farther_m) const {
  constexpr float kRounding = 0.97F;
  const float reach = reach_m(nearer_m, reach_per_m_), deeper_m = farther_m - nearer_m;
  const float across_m2 =
      farther_m * farther_m * (grid_.column_rad * grid_.column_rad + grid_.row_rad * grid_.row_rad);
  return deeper_m * deeper_m + across_m2 < kRounding * (reach * reach);
}

// A return that the nearest one of its pixel hides, at an edge, goes with what it touches in the pixels
// around.
std::int32_t Clusters::surface_of(const ProjectedScan& scan, std::uint32_t row, std::int32_t own) const {
  constexpr int kAround = 2;
  constexpr float kFar = std::numeric_limits<float>::infinity();
  const auto distance_m2 = [&](std::int32_t pixel) {
    constexpr float kRoundingM = 0.01F;
    const Nearest nearest = nearest_[pixel];
    if (nearest == kNothing) return kFar;
    const float range_m = range_of(nearest), nearer_m = std::min(range_m, scan.range_m[row]);
    // Most are too far apart by their ranges alone.
    if (std::abs(range_m - scan.range_m[row]) > reach_m(nearer_m, reach_per_m_) + kRoundingM) return kFar;
    const std::int32_t there = row_of(nearest);
    const float dx = scan.x_m[there] - scan.x_m[row], dy = scan.y_m[there] - scan.y_m[row],
                dz = scan.z_m[there] - scan.z_m[row];
    return together(dx, dy, dz, nearer_m, reach_per_m_) ? dx * dx + (dy * dy + dz * dz) : kFar;
  };
  // Either as often as not, so that a branch for each would be foretold wrongly.
  const bool in_front = row_of(nearest_[own]) == static_cast<std::int32_t>(row);
  if (in_front | share_a_surface(range_of(nearest_[own]), scan.range_m[row]) || distance_m2(own) < kFar)
    return own;
  const int own_column = own / grid_.rows, own_row = own % grid_.rows;
  std::int32_t closest = kNone;
  float closest_m2 = kFar;
  for (int c = own_column - kAround; c <= own_column + kAround; ++c) {
    const int column = (c + grid_.columns) % grid_.columns;
    const int low = std::max(used_[column].low, own_row - kAround);
    const int high = std::min(used_[column].high, own_row + kAround + 1);
    for (int r = low; r < high; ++r) {
      const std::int32_t pixel = column * grid_.rows + r;
      const float m2 = distance_m2(pixel);
      if (m2 < closest_m2) closest_m2 = m2, closest = pixel;
    }
  }
  return closest;
}

void Clusters::name_clusters(const ProjectedScan& scan, const std::vector<std::uint32_t>& rows) {
  of_row_.assign(scan.size(), kNone);
  for_rows(rows.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      std::int32_t pixel = surface_of(scan, rows[i], pixel_[i]);
      if (pixel == kNone) continue;
      while (parent_[pixel] != pixel) pixel = parent_[pixel];
      of_row_[rows[i]] = name_[pixel];
    }
  });
}

}  // namespace stillmap
