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
  MeasuredRange at(int pixel) const { return measured(spans_[pixel], step_m_); }
  /// Of n elements in these directions and at these ranges: raises told[i] to `conflict` where a pixel
  /// contradicts the element, to `support` where it supports it. See classify().
  void tell(std::size_t n, const float* azimuth_rad, const float* elevation_rad, const float* range_m,
            const LevelModel& model, int conflict, int support, int* told) const;
  const SphericalGrid& grid() const { return grid_; }
  float step_m() const { return step_m_; }
  /// The pixels of a column from the lowest row, each packed: the nearest return in the low half, the
  /// farthest in the high one, in steps of step_m(); farthest 0 = no return.
  const std::uint32_t* column(int column) const {
    return &spans_[static_cast<std::size_t>(column) * static_cast<std::size_t>(grid_.rows)];
  }

 private:
  using PackedSpan = std::uint32_t;  ///< for vector registers; see column()
  static constexpr PackedSpan kNoReturn = 0xFFFF;
  static MeasuredRange measured(PackedSpan span, float step_m) {
    return {static_cast<float>(static_cast<int>(span & 0xFFFF)) * step_m,
            static_cast<float>(static_cast<int>(span >> 16)) * step_m};
  }

  void tell_pixels(std::size_t n, const int* pixel, const float* range_m, const LevelModel& level,
                   int conflict, int support, int* told) const;

  SphericalGrid grid_;
  float step_m_ = 0;
  std::vector<PackedSpan> spans_;  ///< by pixel; one more at the end, without a return, for what lies outside
};

}  // namespace stillmap
