#include "stillmap/range_image.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "column_bracket.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

constexpr float kRad = 0.01745329252F;
constexpr float kTwoPi = 6.28318530717959F;
constexpr float kSteps = 65000.0F;

SpanPlanes span_planes(const ProjectedScan& scan, const SphericalGrid& grid, float step_m) {
  SpanPlanes planes{Plane(grid.size(), 0xFFFF), Plane(grid.size(), 0)};
  const float inverse_step = 1.0F / step_m;
  constexpr std::size_t kAtOnce = 512;
  int pixels[kAtOnce];
  for (std::size_t first = 0; first < scan.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, scan.size() - first);
    grid.pixels(count, &scan.azimuth_rad[first], &scan.elevation_rad[first], pixels);
    for (std::size_t i = 0; i < count; ++i) {
      const float range_m = scan.range_m[first + i];
      if (!(range_m > 0) || pixels[i] < 0) continue;
      const auto range = static_cast<std::uint16_t>(std::max(1.0F, range_m * inverse_step + 0.5F));
      planes.nearest[pixels[i]] = std::min(planes.nearest[pixels[i]], range);
      planes.farthest[pixels[i]] = std::max(planes.farthest[pixels[i]], range);
    }
  }
  return planes;
}

}  // namespace

SphericalGrid::SphericalGrid(float column, float row, float elevation_min, float elevation_max)
    : row_rad(row), elevation_min_rad(elevation_min - row) {
  columns = std::max(8, static_cast<int>(std::floor(kTwoPi / column)));
  column_rad = kTwoPi / columns;
  rows = static_cast<int>(std::ceil((elevation_max - elevation_min) / row)) + 3;
  inverse_column_ = 1.0F / column_rad;
  inverse_row_ = 1.0F / row_rad;
}

STILLMAP_VECTOR_CLONES void SphericalGrid::pixels(std::size_t n, const float* __restrict azimuth_rad,
                                                  const float* __restrict elevation_rad,
                                                  int* __restrict pixel) const {
  const SphericalGrid grid = *this;  // so that the compiler need not read it again after each write
  for (std::size_t i = 0; i < n; ++i) pixel[i] = grid.pixel(azimuth_rad[i], elevation_rad[i]);
}

RangeImage RangeImage::nearest(const ProjectedScan& scan, float level_rad, float max_range_m) {
  RangeImage image;
  image.step_m_ = max_range_m / kSteps;
  image.grid_ = SphericalGrid(level_rad, level_rad, scan.elevation_min_rad, scan.elevation_max_rad);
  const SpanPlanes planes = span_planes(scan, image.grid_, image.step_m_);
  image.spans_.resize(image.grid_.size());
  for (std::size_t i = 0; i < image.spans_.size(); ++i) {
    const std::uint16_t range = planes.farthest[i] > 0 ? planes.nearest[i] : std::uint16_t{0};
    image.spans_[i] = {range, range};
  }
  image.make_tiles();
  for (int column = 0; column < image.tile_columns_; ++column) image.summarise_tiles(column);
  return image;
}

RangeImage RangeImage::bracketed(const ProjectedScan& scan, SensorGeometry geometry, float max_range_m) {
  const float column_rad = std::max(0.4F * kRad, 1.5F * geometry.azimuth_step_rad);
  const float row_rad = 0.15F * kRad;
  const int gap_rows = static_cast<int>(std::ceil(1.25F * geometry.ring_spacing_rad / row_rad));
  const float margin = gap_rows * row_rad;

  RangeImage image;
  image.step_m_ = max_range_m / kSteps;
  image.grid_ =
      SphericalGrid(column_rad, row_rad, scan.elevation_min_rad - margin, scan.elevation_max_rad + margin);
  const SpanPlanes planes = span_planes(scan, image.grid_, image.step_m_);
  image.spans_.resize(image.grid_.size());
  image.make_tiles();
  tbb::parallel_for(0, image.tile_columns_, [&](int tile_column) {
    WideColumn wide;
    ColumnBracket bracket(image.grid_.rows, 2, gap_rows);
    const int last = std::min(image.grid_.columns, (tile_column + 1) * kTileColumns);
    for (int column = tile_column * kTileColumns; column < last; ++column) {
      wide.gather(planes, image.grid_, column);
      Span* const spans = &image.spans_[static_cast<std::size_t>(column) * image.grid_.rows];
      bracket.run(wide.nearest.data(), wide.farthest.data(),
                  [&](int row, std::uint16_t near, std::uint16_t far) {
                    spans[row] = {near, far};
                  });
    }
    image.summarise_tiles(tile_column);
  });
  return image;
}

void RangeImage::make_tiles() {
  tile_columns_ = (grid_.columns + kTileColumns - 1) / kTileColumns;
  tile_rows_ = (grid_.rows + kTileRows - 1) / kTileRows;
  tiles_.assign(static_cast<std::size_t>(tile_columns_) * tile_rows_, Span{0xFFFF, 0});
}

void RangeImage::summarise_tiles(int tile_column) {
  const int last = std::min(grid_.columns, (tile_column + 1) * kTileColumns);
  Span* const tiles = &tiles_[static_cast<std::size_t>(tile_column) * tile_rows_];
  for (int column = tile_column * kTileColumns; column < last; ++column) {
    const Span* const spans = &spans_[static_cast<std::size_t>(column) * grid_.rows];
    for (int row = 0; row < grid_.rows; ++row) {
      if (spans[row].farthest == 0) continue;
      Span& tile = tiles[row / kTileRows];
      tile.nearest = std::min(tile.nearest, spans[row].nearest);
      tile.farthest = std::max(tile.farthest, spans[row].farthest);
    }
  }
}

void RangeImage::at(std::size_t n, const float* azimuth_rad, const float* elevation_rad, float* nearest_m,
                    float* farthest_m) const {
  constexpr std::size_t kAtOnce = 256;
  int pixel[kAtOnce];
  for (std::size_t first = 0; first < n; first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, n - first);
    grid_.pixels(count, azimuth_rad + first, elevation_rad + first, pixel);
    for (std::size_t i = 0; i < count; ++i) {
      const MeasuredRange measured = pixel[i] < 0 ? MeasuredRange{} : at(pixel[i]);
      nearest_m[first + i] = measured.nearest_m;
      farthest_m[first + i] = measured.farthest_m;
    }
  }
}

MeasuredRange RangeImage::around(float azimuth_rad, float elevation_rad, float half_angle_rad) const {
  // Towards the zenith a cap of the sphere spans more azimuth.
  const float wide_rad = half_angle_rad / std::max(0.1F, std::cos(std::abs(elevation_rad) + half_angle_rad));
  const int half_columns = static_cast<int>(wide_rad / grid_.column_rad) / kTileColumns + 1;
  const int middle = grid_.column(azimuth_rad) / kTileColumns;
  const int first_row = std::max(0, grid_.row(elevation_rad - half_angle_rad) / kTileRows);
  const int last_row = std::min(tile_rows_ - 1, grid_.row(elevation_rad + half_angle_rad) / kTileRows);
  const int first = 2 * half_columns + 1 >= tile_columns_ ? 0 : middle - half_columns;
  const int count = std::min(tile_columns_, 2 * half_columns + 1);
  Span all{0xFFFF, 0};
  for (int i = 0; i < count; ++i) {
    const int column = (first + i + tile_columns_) % tile_columns_;
    for (int row = first_row; row <= last_row; ++row) {
      const Span tile = tiles_[static_cast<std::size_t>(column) * tile_rows_ + row];
      all.nearest = std::min(all.nearest, tile.nearest);
      all.farthest = std::max(all.farthest, tile.farthest);
    }
  }
  return {all.nearest * step_m_, all.farthest * step_m_};
}

}  // namespace stillmap
