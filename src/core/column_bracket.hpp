#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "stillmap/range_image.hpp"
#include "vector_clones.hpp"

namespace stillmap {

using Plane = std::vector<std::uint16_t>;

/// Nearest (none = 65535) and farthest (none = 0) return of each pixel.
struct SpanPlanes {
  Plane nearest, farthest;
};

/// One column that also sees its two neighbours; columns wrap around.
struct WideColumn {
  Plane nearest, farthest;

  STILLMAP_VECTOR_CLONES void gather(const SpanPlanes& planes, const SphericalGrid& grid, int column) {
    const auto rows = static_cast<std::size_t>(grid.rows);
    nearest.resize(rows);
    farthest.resize(rows);
    const std::size_t left = (column + grid.columns - 1) % grid.columns * rows, here = column * rows;
    const std::size_t right = (column + 1) % grid.columns * rows;
    std::uint16_t* __restrict near = nearest.data();
    std::uint16_t* __restrict far = farthest.data();
    const std::uint16_t *n = planes.nearest.data(), *f = planes.farthest.data();
    for (std::size_t r = 0; r < rows; ++r) {
      near[r] = std::min(std::min(n[left + r], n[here + r]), n[right + r]);
      far[r] = std::max(std::max(f[left + r], f[here + r]), f[right + r]);
    }
  }
};

/// The beams around each row of one column: the rows within `reach` of it, and the nearest row with a return
/// strictly below and strictly above, at most `gap` rows away. A row that served as both sides would see
/// through the ground between two rings.
class ColumnBracket {
 public:
  ColumnBracket(int rows, int reach, int gap) : reach_(reach), gap_(gap), below_(rows), above_(rows) {}

  template <class Emit>
  void run(const std::uint16_t* nearest, const std::uint16_t* farthest, Emit&& emit) {
    const int rows = static_cast<int>(below_.size());
    for (int r = 0, last = -1; r < rows; ++r) {
      below_[r] = last >= 0 && r - last <= gap_ ? last : -1;
      if (farthest[r] > 0) last = r;
    }
    for (int r = rows - 1, last = -1; r >= 0; --r) {
      above_[r] = last >= 0 && last - r <= gap_ ? last : -1;
      if (farthest[r] > 0) last = r;
    }
    for (int r = 0; r < rows; ++r) {
      std::uint16_t near = 0xFFFF, far = 0;
      const auto include = [&](int row) {
        near = std::min(near, nearest[row]);
        far = std::max(far, farthest[row]);
      };
      for (int row = std::max(0, r - reach_); row <= std::min(rows - 1, r + reach_); ++row) include(row);
      const bool own = far > 0;
      if (below_[r] >= 0) include(below_[r]);
      if (above_[r] >= 0) include(above_[r]);
      // Nothing passes below the lowest beam, and nothing is known beyond the reach of one.
      const bool known = below_[r] >= 0 && (above_[r] >= 0 || own);
      if (!known) near = 0xFFFF, far = 0;
      emit(r, near, far);
    }
  }

 private:
  int reach_, gap_;
  std::vector<int> below_, above_;
};

}  // namespace stillmap
