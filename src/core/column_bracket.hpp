#pragma once

#include <cstdint>
#include <vector>

#include "stillmap/range_image.hpp"

namespace stillmap {

/// By pixel, or by row of a column.
using Plane = std::vector<std::uint16_t>;

/// Nearest (none = 65535) and farthest (none = 0) return of each pixel.
struct SpanPlanes {
  SpanPlanes() = default;
  explicit SpanPlanes(std::size_t size) : nearest(size, 0xFFFF), farthest(size, 0) {}
  Plane nearest, farthest;
};

/// The beams around each row of one column: the rows within kReach of it, and the nearest row with a return
/// strictly below and strictly above, at most `gap` rows away. A row that served as both sides would see
/// through the ground between two rings. A column also sees its two neighbours; columns wrap around.
class ColumnBracket {
 public:
  ColumnBracket(const SphericalGrid& grid, int gap);

  /// Nearest return in the low half of each span, farthest in the high one; farthest 0 = nothing known.
  void run(const SpanPlanes& planes, int column, std::uint32_t* spans);

 private:
  void widen(const SpanPlanes& planes, int column);
  /// For each row the first return of `gap` rows from itself on, upwards (1) or downwards (-1).
  void look(int step, SpanPlanes& found);
  std::size_t padded_rows() const { return static_cast<std::size_t>(grid_.rows) + 2 * margin_; }

  static constexpr int kReach = 2;
  SphericalGrid grid_;
  int gap_;
  std::size_t margin_;  ///< empty rows at both ends of those below
  SpanPlanes wide_, below_, above_, before_;
};

}  // namespace stillmap
