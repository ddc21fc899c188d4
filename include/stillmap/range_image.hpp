#pragma once

#include <cstdint>
#include <vector>

#include "stillmap/evidence.hpp"
#include "stillmap/projection.hpp"
#include "stillmap/sensor_geometry.hpp"

namespace stillmap {

/// Pixels of equal angle: columns in azimuth all around, rows in elevation between two bounds.
struct SphericalGrid {
  float column_rad = 0, row_rad = 0;
  float elevation_min_rad = 0;
  int columns = 0, rows = 0;

  SphericalGrid() = default;
  /// Columns are made to divide the circle; a row more than needed at both ends.
  SphericalGrid(float column_rad, float row_rad, float elevation_min_rad, float elevation_max_rad);

  int column(float azimuth_rad) const {
    constexpr float kPi = 3.14159265358979F;
    const int c = static_cast<int>((azimuth_rad + kPi) * inverse_column_);
    return c < columns ? c : columns - 1;
  }
  /// May lie outside [0, rows).
  int row(float elevation_rad) const {
    const float r = (elevation_rad - elevation_min_rad) * inverse_row_;
    return r < 0 ? -1 : static_cast<int>(r);
  }
  /// Index of the pixel, column by column, or -1 outside the rows.
  int pixel(float azimuth_rad, float elevation_rad) const {
    const int r = row(elevation_rad);
    return r < 0 || r >= rows ? -1 : column(azimuth_rad) * rows + r;
  }
  /// pixel() of n directions at once, in vector registers.
  void pixels(std::size_t n, const float* azimuth_rad, const float* elevation_rad, int* pixel) const;
  std::size_t size() const { return static_cast<std::size_t>(columns) * rows; }

 private:
  float inverse_column_ = 0, inverse_row_ = 0;
};

/// I_O of one angular level: for each pixel what the scan measured there. Ranges are kept in 16 bits, in
/// steps of max_range_m / 65000.
class RangeImage {
 public:
  /// Eq. (2), literal: the nearest return in each pixel of `level_rad`.
  static RangeImage nearest(const ProjectedScan& scan, float level_rad, float max_range_m);
  /// Near the sensor's own beam spacing: each pixel knows the nearest and farthest return of the beams around
  /// it, and says something only where a beam passes or beams on both sides bracket it.
  static RangeImage bracketed(const ProjectedScan& scan, SensorGeometry geometry, float max_range_m);

  MeasuredRange at(float azimuth_rad, float elevation_rad) const {
    const int pixel = grid_.pixel(azimuth_rad, elevation_rad);
    return pixel < 0 ? MeasuredRange{} : at(pixel);
  }
  MeasuredRange at(int pixel) const {
    const Span span = spans_[pixel];
    return {span.nearest * step_m_, span.farthest * step_m_};
  }
  /// at() of n directions at once; 0 where there is no return.
  void at(std::size_t n, const float* azimuth_rad, const float* elevation_rad, float* nearest_m,
          float* farthest_m) const;
  /// Nearest and farthest return of all pixels within `half_angle_rad` of a direction, and of some more
  /// around: whatever lies there was measured inside this span.
  MeasuredRange around(float azimuth_rad, float elevation_rad, float half_angle_rad) const;
  const SphericalGrid& grid() const { return grid_; }

 private:
  struct Span {
    std::uint16_t nearest, farthest;  ///< farthest 0 = no return
  };

  void make_tiles();
  void summarise_tiles(int tile_column);

  static constexpr int kTileColumns = 8, kTileRows = 16;
  SphericalGrid grid_;
  float step_m_ = 0;
  std::vector<Span> spans_;
  int tile_columns_ = 0, tile_rows_ = 0;
  std::vector<Span>
      tiles_;  ///< span of kTileColumns x kTileRows pixels, column by column; nearest 65535 = none
};

}  // namespace stillmap
