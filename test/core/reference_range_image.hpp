#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace stillmap::reference {

/// Nearest and farthest range around a direction, metres.
struct Span {
  double nearest_m, farthest_m;
};

/// A return, or what is asked about: direction and range.
struct Direction {
  double azimuth_rad, elevation_rad, range_m;
};

/// The range images, slow and obvious: pixels are kept in a std::map and looked up one by one.
class RangeImage {
 public:
  /// The nearest return of each pixel of level_rad.
  static RangeImage nearest(const std::vector<Direction>& returns, double level_rad, double max_range_m) {
    return RangeImage(returns, level_rad, level_rad, 0, max_range_m);
  }
  /// The beams around each pixel, near the sensor's own spacing.
  static RangeImage bracketed(const std::vector<Direction>& returns, double ring_spacing_rad,
                              double azimuth_step_rad, double max_range_m) {
    const double row_rad = 0.15 * kRad;
    const int gap = static_cast<int>(std::ceil(1.25 * ring_spacing_rad / row_rad));
    const double steps_in_column = azimuth_step_rad == ring_spacing_rad ? 1.2 : 1.5;  // without rings
    const double column_rad = std::max(0.4 * kRad, steps_in_column * azimuth_step_rad);
    return RangeImage(returns, column_rad, row_rad, gap, max_range_m);
  }

  std::pair<int, int> pixel(const Direction& d) const {  // column, row
    const int column = static_cast<int>((d.azimuth_rad + kPi) / column_rad_);
    return {std::min(column, columns_ - 1),
            static_cast<int>(std::floor((d.elevation_rad - elevation_min_rad_) / row_rad_))};
  }

  std::optional<Span> at(const Direction& d) const { return at(pixel(d)); }
  std::optional<Span> at(const std::pair<int, int>& pixel) const {
    return gap_rows_ == 0 ? own_pixel(pixel.first, pixel.second) : around(pixel.first, pixel.second);
  }

 private:
  static constexpr double kPi = 3.14159265358979, kRad = kPi / 180;

  RangeImage(const std::vector<Direction>& returns, double column_rad, double row_rad, int gap_rows,
             double max_range_m)
      : step_m_(max_range_m / 65000), row_rad_(row_rad), gap_rows_(gap_rows) {
    columns_ = std::max(8, static_cast<int>(std::floor(2 * kPi / column_rad)));
    column_rad_ = 2 * kPi / columns_;
    double lowest = 2, highest = -2;
    for (const Direction& d : returns) {
      lowest = std::min(lowest, d.elevation_rad);
      highest = std::max(highest, d.elevation_rad);
    }
    elevation_min_rad_ = lowest - (gap_rows + 1) * row_rad;
    for (const Direction& d : returns) {
      const double kept_m = std::max(1.0, std::floor(d.range_m / step_m_ + 0.5)) * step_m_;
      const auto [it, created] = pixels_.try_emplace(pixel(d), Span{kept_m, kept_m});
      it->second = {std::min(it->second.nearest_m, kept_m), std::max(it->second.farthest_m, kept_m)};
    }
  }

  std::optional<Span> own_pixel(int column, int row) const {
    const auto it = pixels_.find({column, row});
    return it == pixels_.end() ? std::nullopt
                               : std::make_optional(Span{it->second.nearest_m, it->second.nearest_m});
  }

  /// Of the column and its two neighbours.
  std::optional<Span> wide(int column, int row) const {
    std::optional<Span> span;
    for (int side = -1; side <= 1; ++side) {
      const auto it = pixels_.find({(column + side + columns_) % columns_, row});
      if (it != pixels_.end()) include(it->second, span);
    }
    return span;
  }

  std::optional<Span> around(int column, int row) const {
    constexpr int kReach = 2;
    std::optional<Span> own, below, above;
    for (int r = row - kReach; r <= row + kReach; ++r)
      if (const auto span = wide(column, r)) include(*span, own);
    for (int r = row - 1; r >= row - gap_rows_ && !below; --r) below = wide(column, r);
    for (int r = row + 1; r <= row + gap_rows_ && !above; ++r) above = wide(column, r);
    if (!below || !(above || own)) return std::nullopt;
    std::optional<Span> span = below;
    if (own) include(*own, span);
    if (above) include(*above, span);
    return span;
  }

  static void include(const Span& more, std::optional<Span>& span) {
    if (!span) span = more;
    span = Span{std::min(span->nearest_m, more.nearest_m), std::max(span->farthest_m, more.farthest_m)};
  }

  double step_m_, column_rad_ = 0, row_rad_, elevation_min_rad_ = 0;
  int columns_ = 0, gap_rows_;  ///< 0: pixels stand alone
  std::map<std::pair<int, int>, Span> pixels_;
};

}  // namespace stillmap::reference
