#include "stillmap/range_image.hpp"

#include <algorithm>
#include <cmath>

#include "column_bracket.hpp"
#include "on_all_threads.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

constexpr float kRad = 0.01745329252F;
constexpr float kTwoPi = 6.28318530717959F;
constexpr float kSteps = 65000.0F;

SpanPlanes span_planes(const ProjectedScan& scan, const SphericalGrid& grid, float step_m) {
  SpanPlanes planes(grid.size());
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
  image.spans_.resize(image.grid_.size() + 1, kNoReturn);
  for (std::size_t i = 0; i < image.grid_.size(); ++i) {
    const bool any = planes.farthest[i] > 0;
    image.spans_[i] = any ? planes.nearest[i] | PackedSpan{planes.nearest[i]} << 16 : kNoReturn;
  }
  return image;
}

RangeImage RangeImage::bracketed(const ProjectedScan& scan, SensorGeometry geometry, float max_range_m) {
  const float steps_in_column = geometry.has_rings() ? 1.5F : 1.2F;
  const float column_rad = std::max(0.4F * kRad, steps_in_column * geometry.azimuth_step_rad);
  const float row_rad = 0.15F * kRad;
  const int gap_rows = static_cast<int>(std::ceil(1.25F * geometry.ring_spacing_rad / row_rad));
  const float margin = gap_rows * row_rad;

  RangeImage image;
  image.step_m_ = max_range_m / kSteps;
  image.grid_ =
      SphericalGrid(column_rad, row_rad, scan.elevation_min_rad - margin, scan.elevation_max_rad + margin);
  const SpanPlanes planes = span_planes(scan, image.grid_, image.step_m_);
  image.spans_.resize(image.grid_.size() + 1, kNoReturn);
  for_pieces(static_cast<std::size_t>(image.grid_.columns), 64, [&](std::size_t first, std::size_t last) {
    ColumnBracket bracket(image.grid_, gap_rows);
    for (std::size_t column = first; column < last; ++column)
      bracket.run(planes, static_cast<int>(column), &image.spans_[column * image.grid_.rows]);
  });
  return image;
}

STILLMAP_VECTOR_CLONES void RangeImage::tell_pixels(std::size_t n, const int* __restrict pixel,
                                                    const float* __restrict range_m, const LevelModel& model,
                                                    int conflict, int support, int* __restrict told) const {
  const LevelModel level = model;  // so that the compiler need not read it again after each write
  const PackedSpan* __restrict spans = spans_.data();
  const auto outside = static_cast<unsigned>(grid_.size());
  const float step_m = step_m_;
  for (std::size_t i = 0; i < n; ++i) {
    const MeasuredRange seen = measured(spans[std::min(static_cast<unsigned>(pixel[i]), outside)], step_m);
    const Evidence evidence = classify(range_m[i], seen, level);
    const int says = evidence == Evidence::kConflict  ? conflict
                     : evidence == Evidence::kSupport ? support
                                                      : 0;
    told[i] = std::max(told[i], says);
  }
}

void RangeImage::tell(std::size_t n, const float* azimuth_rad, const float* elevation_rad,
                      const float* range_m, const LevelModel& level, int conflict, int support,
                      int* told) const {
  constexpr std::size_t kAtOnce = 512;
  int pixel[kAtOnce];
  for (std::size_t first = 0; first < n; first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, n - first);
    grid_.pixels(count, azimuth_rad + first, elevation_rad + first, pixel);
    tell_pixels(count, pixel, range_m + first, level, conflict, support, told + first);
  }
}

}  // namespace stillmap
