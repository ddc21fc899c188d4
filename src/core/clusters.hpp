#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "stillmap/range_image.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// Connected pieces of the surface in one scan, found on its image: two returns belong together when their
/// pixels are neighbours and they lie closer than the beams' spacing there explains.
class Clusters {
 public:
  static constexpr std::int32_t kNone = kNoObject;

  /// Of the rows that are given, ascending; they have a usable return. The others take no part.
  void find(const ProjectedScan& scan, SensorGeometry geometry, const std::vector<std::uint32_t>& rows);

  /// Cluster of each row, 0 .. count() - 1, or kNone.
  const std::vector<std::int32_t>& of_row() const { return of_row_; }
  std::size_t count() const { return count_; }

  /// Pixels of the image, and that of a direction between those of the scan.
  std::size_t pixels() const { return grid_.size(); }
  int pixel(float azimuth_rad, float elevation_rad) const {
    return grid_.column(azimuth_rad) * grid_.rows + std::clamp(grid_.row(elevation_rad), 0, grid_.rows - 1);
  }
  /// Whether the test holds for one of the rows that took part, up to about two rings above a pixel.
  template <class Test>
  bool any_above(int pixel, Test&& test) const {
    const int row = pixel % grid_.rows, column = pixel / grid_.rows;
    for (int c = column - 1; c <= column + 1; ++c)
      for (int r = row; r <= std::min(grid_.rows - 1, row + kAbove); ++r) {
        const Nearest above = nearest_[(c + grid_.columns) % grid_.columns * grid_.rows + r];
        if (above != kNothing && test(row_of(above))) return true;
      }
    return false;
  }
  /// Whether any_above() may come upon a row, in its pixel.
  bool is_in_front(std::uint32_t row, int pixel) const {
    return nearest_[pixel] != kNothing && row_of(nearest_[pixel]) == static_cast<std::int32_t>(row);
  }
  /// Calls visit(pixel) for those from which it looks at a pixel.
  template <class Visitor>
  void for_each_below(int pixel, Visitor&& visit) const {
    const int row = pixel % grid_.rows, column = pixel / grid_.rows;
    for (int c = column - 1; c <= column + 1; ++c)
      for (int r = std::max(0, row - kAbove); r <= row; ++r)
        visit((c + grid_.columns) % grid_.columns * grid_.rows + r);
  }

 private:
  /// The nearest return of a pixel: the bits of its range above its row, so that the least is the nearest.
  using Nearest = std::uint64_t;
  static constexpr Nearest kNothing = ~Nearest{0};
  static constexpr int kAbove = 3;  ///< rows of pixels, about two rings
  /// Columns that one task joins; what reaches over their edge is joined afterwards.
  static constexpr int kStripe = 64;
  static std::int32_t row_of(Nearest nearest) { return static_cast<std::int32_t>(nearest & 0xFFFFFFFF); }
  static float range_of(Nearest nearest);
  static Nearest nearest(float range_m, std::uint32_t row);
  /// Some rows of a column.
  struct Span {
    int low, high;
    bool empty() const { return low >= high; }
  };

  void place_rows(const ProjectedScan& scan, const std::vector<std::uint32_t>& rows);
  void empty_columns();
  void link_columns(const ProjectedScan& scan, int first, int last);
  void load_column(const ProjectedScan& scan, int column, Span span,
                   const std::array<float*, 4>& planes) const;
  bool share_a_surface(float nearer_m, float farther_m) const;
  std::int32_t surface_of(const ProjectedScan& scan, std::uint32_t row, std::int32_t own) const;
  void name_clusters(const ProjectedScan& scan, const std::vector<std::uint32_t>& rows);
  // cluster_joins.cpp
  void join_stripe(int first, int last, std::vector<std::int32_t>& roots);
  void join_stripes();
  void join_column(int column, unsigned steps);
  void join(std::int32_t a, std::int32_t b);
  std::int32_t root(std::int32_t pixel);

  SphericalGrid grid_;
  float reach_per_m_ = 0;  ///< how much farther apart two returns may lie for each metre of range
  std::vector<std::int32_t> pixel_, column_;  ///< of the rows that take part, in their order
  std::vector<Span> used_;                    ///< by column: no return lies outside
  // By pixel; all but the nearest are kept up where they are used only.
  std::vector<Nearest> nearest_;
  std::vector<std::uint16_t> links_;  ///< of each pixel: to which of its neighbours it is connected
  std::vector<std::int32_t> parent_;  ///< union-find over pixels; never more than the pixel itself
  std::vector<std::vector<std::int32_t>> roots_;  ///< by stripe of columns: pixels that are their own parent
  std::vector<std::int32_t> name_, of_row_;
  std::size_t count_ = 0;
};

}  // namespace stillmap
