#include "coarse_image.hpp"

#include <algorithm>
#include <cmath>

#include "on_all_threads.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

constexpr float kPi = 3.14159265358979F;

/// Takes one more column into what is known of each row of a tile: the largest nearest return, and the
/// farthest return of what can be one surface. An element that a pixel supports is at most epsilon behind its
/// farthest return.
STILLMAP_VECTOR_CLONES void take_column(std::size_t rows, const std::uint32_t* __restrict spans,
                                        const LevelModel& of_level, float step_m, int* __restrict conflict,
                                        int* __restrict support) {
  const LevelModel level = of_level;
  for (std::size_t r = 0; r < rows; ++r) {
    const int nearest = static_cast<int>(spans[r] & 0xFFFF), farthest = static_cast<int>(spans[r] >> 16);
    const float reach_m = static_cast<float>(farthest) * step_m + level.epsilon_m;
    const float span_m = static_cast<float>(farthest - nearest - 1) * step_m;
    conflict[r] = std::max(conflict[r], farthest > 0 ? nearest : 0);
    support[r] = std::max(support[r], span_m <= level.one_surface_m(reach_m) ? farthest : 0);
  }
}

}  // namespace

CoarseImage::CoarseImage(const RangeImage& image, const LevelModel& level)
    : grid_(image.grid()),
      level_(level),
      step_m_(image.step_m()),
      tile_columns_((grid_.columns + kTileColumns - 1) / kTileColumns),
      tile_rows_((grid_.rows + kTileRows - 1) / kTileRows),
      tiles_(static_cast<std::size_t>(tile_columns_) * static_cast<std::size_t>(tile_rows_)) {
  for_pieces(static_cast<std::size_t>(tile_columns_), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t column = first; column < last; ++column) summarise(image, static_cast<int>(column));
  });
}

void CoarseImage::summarise(const RangeImage& image, int tile_column) {
  const auto rows = static_cast<std::size_t>(grid_.rows);
  const int first = tile_column * kTileColumns, last = std::min(grid_.columns, first + kTileColumns);
  std::vector<int> conflict(rows, 0), support(rows, 0);
  for (int column = first; column < last; ++column)
    take_column(rows, image.column(column), level_, step_m_, conflict.data(), support.data());
  Tile* const tiles = &tiles_[static_cast<std::size_t>(tile_column) * static_cast<std::size_t>(tile_rows_)];
  for (int tile = 0; tile < tile_rows_; ++tile) {
    const int begin = tile * kTileRows, end = std::min(grid_.rows, begin + kTileRows);
    tiles[tile] = {
        static_cast<std::uint16_t>(*std::max_element(conflict.begin() + begin, conflict.begin() + end)),
        static_cast<std::uint16_t>(*std::max_element(support.begin() + begin, support.begin() + end))};
  }
}

bool CoarseImage::may_tell(const Tile& tile, float nearest_m) const {
  const float slack_m = step_m_;  // of rounding
  return tile.farthest_conflict * step_m_ - nearest_m + slack_m > level_.tau_m(nearest_m) ||
         tile.farthest_support * step_m_ + level_.epsilon_m + slack_m >= nearest_m;
}

bool CoarseImage::may_tell(const Spherical& center, float radius_m) const {
  constexpr float kNearPole_rad = 1.4F;
  if (center.range_m < 3 * radius_m) return true;
  // A little more than asin(radius / range); a ball far up spans more azimuth.
  const float half_rad = 1.1F * radius_m / center.range_m;
  const float highest_rad = std::abs(center.elevation_rad) + half_rad;
  if (highest_rad > kNearPole_rad) return true;
  const float wide_rad = half_rad / std::cos(highest_rad);
  if (wide_rad > 0.5F * kPi) return true;
  const int first_row = std::max(0, grid_.row(center.elevation_rad - half_rad) / kTileRows);
  const int last_row = std::min(tile_rows_ - 1, grid_.row(center.elevation_rad + half_rad) / kTileRows);
  const float left_rad = center.azimuth_rad - wide_rad, right_rad = center.azimuth_rad + wide_rad;
  int column = grid_.column(left_rad < -kPi ? left_rad + 2 * kPi : left_rad) / kTileColumns;
  const int last = grid_.column(right_rad > kPi ? right_rad - 2 * kPi : right_rad) / kTileColumns;
  for (;; column = column + 1 == tile_columns_ ? 0 : column + 1) {
    const Tile* const tiles =
        &tiles_[static_cast<std::size_t>(column) * static_cast<std::size_t>(tile_rows_)];
    for (int row = first_row; row <= last_row; ++row)
      if (may_tell(tiles[row], center.range_m - radius_m)) return true;
    if (column == last) return false;
  }
}

CoarseView::CoarseView(const ScanView& view, const std::vector<LevelModel>& models) {
  for (std::size_t r = 0; r < models.size(); ++r) levels_.emplace_back(view.levels()[r], models[r]);
}

bool CoarseView::may_tell(const Eigen::Vector3f& center_sensor_m, float radius_m) const {
  const Spherical center = spherical(center_sensor_m);
  return std::any_of(levels_.begin(), levels_.end(),
                     [&](const CoarseImage& level) { return level.may_tell(center, radius_m); });
}

}  // namespace stillmap
