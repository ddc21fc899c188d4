#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "stillmap/range_image.hpp"

namespace stillmap {

/// Connected pieces of the surface in one scan, found on its image: two returns belong together when their
/// pixels are neighbours and they lie closer than the beams' spacing there explains.
class Clusters {
 public:
  static constexpr std::int32_t kNone = -1;

  /// Rows with use[row] == 0 take no part.
  void find(const ProjectedScan& scan, SensorGeometry geometry, const std::vector<std::uint8_t>& use);

  /// Cluster of each row, 0 .. count() - 1, or kNone.
  const std::vector<std::int32_t>& of_row() const { return of_row_; }
  std::size_t count() const { return count_; }

  /// Columns of the image all around, and that of a direction.
  int columns() const { return grid_.columns; }
  int column(float azimuth_rad) const { return grid_.column(azimuth_rad); }
  /// Whether the test holds for one of the rows that took part, up to about two rings above a direction.
  template <class Test>
  bool any_above(float azimuth_rad, float elevation_rad, Test&& test) const {
    const int row = grid_.row(elevation_rad), column = grid_.column(azimuth_rad);
    for (int c = column - 1; c <= column + 1; ++c)
      for (int r = std::max(0, row); r <= std::min(grid_.rows - 1, row + 3); ++r) {
        const std::int32_t above = nearest_[(c + grid_.columns) % grid_.columns * grid_.rows + r].row;
        if (above != kNone && test(above)) return true;
      }
    return false;
  }

 private:
  void place_rows(const ProjectedScan& scan, const std::vector<std::uint8_t>& use);
  void empty_columns();
  void link_columns(int first, int last);
  void join_links();
  std::int32_t surface_of(const ProjectedScan& scan, std::size_t row) const;
  void name_clusters(const ProjectedScan& scan);
  void join(std::int32_t a, std::int32_t b);
  std::int32_t root(std::int32_t pixel);

  /// By ascending pixel.
  template <class Work>
  void for_each_used_pixel(Work&& work) const {
    const auto rows = static_cast<std::size_t>(grid_.rows);
    for (std::size_t column = 0; column < column_used_.size(); ++column)
      for (std::size_t row = 0; column_used_[column] != 0 && row < rows; ++row) work(column * rows + row);
  }

  struct Return {
    float x_m, y_m, z_m, range_m;
    std::int32_t row;  ///< of the scan
  };

  SphericalGrid grid_;
  float reach_per_m_ = 0;  ///< how much farther apart two returns may lie for each metre of range
  std::vector<std::int32_t> pixel_of_row_;  ///< -1: takes no part
  // By pixel; links, parents and names are kept up in used columns only.
  std::vector<Return> nearest_;            ///< NaN at infinity, row kNone where there is none
  std::vector<std::uint8_t> column_used_;  ///< holds a return
  std::vector<std::uint16_t> links_;       ///< of each pixel: to which of its neighbours it is connected
  std::vector<std::int32_t> parent_;       ///< union-find over pixels; never more than the pixel itself
  std::vector<std::int32_t> name_, of_row_;
  std::size_t count_ = 0;
};

}  // namespace stillmap
