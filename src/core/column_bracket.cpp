#include "column_bracket.hpp"

#include <algorithm>
#include <array>

#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// Columns, or one column and the same shifted by some rows: pointers of their own keep the loops below free
/// of what the compiler would carry from row to row.
template <std::size_t kCount>
using Columns = std::array<const std::uint16_t*, kCount>;

STILLMAP_VECTOR_CLONES void join_columns(std::size_t rows, const Columns<3>& nearest,
                                         const Columns<3>& farthest, std::uint16_t* __restrict near,
                                         std::uint16_t* __restrict far) {
  const std::uint16_t *n0 = nearest[0], *n1 = nearest[1], *n2 = nearest[2];
  const std::uint16_t *f0 = farthest[0], *f1 = farthest[1], *f2 = farthest[2];
  for (std::size_t r = 0; r < rows; ++r) {
    near[r] = std::min(std::min(n0[r], n1[r]), n2[r]);
    far[r] = std::max(std::max(f0[r], f1[r]), f2[r]);
  }
}

/// Each row as it is where it has a return; else as the one `step` rows on.
STILLMAP_VECTOR_CLONES void fill_from(std::ptrdiff_t step, std::size_t rows,
                                      const std::uint16_t* __restrict near_before,
                                      const std::uint16_t* __restrict far_before,
                                      std::uint16_t* __restrict near, std::uint16_t* __restrict far) {
  const std::uint16_t *near_there = near_before + step, *far_there = far_before + step;
  for (std::size_t r = 0; r < rows; ++r) {
    const std::uint16_t empty = far_before[r] > 0 ? 0 : 0xFFFF;
    near[r] = static_cast<std::uint16_t>((near_before[r] & ~empty) | (near_there[r] & empty));
    far[r] = static_cast<std::uint16_t>(far_before[r] | (far_there[r] & empty));
  }
}

/// The last two columns are what lies below and above.
STILLMAP_VECTOR_CLONES void bracket(std::size_t rows, const Columns<7>& near, const Columns<7>& far,
                                    std::uint32_t* __restrict spans) {
  const std::uint16_t *n0 = near[0], *n1 = near[1], *n2 = near[2], *n3 = near[3], *n4 = near[4];
  const std::uint16_t *f0 = far[0], *f1 = far[1], *f2 = far[2], *f3 = far[3], *f4 = far[4];
  const std::uint16_t *near_below = near[5], *near_above = near[6], *far_below = far[5], *far_above = far[6];
  for (std::size_t r = 0; r < rows; ++r) {
    const std::uint16_t own_near = std::min(std::min(std::min(n0[r], n1[r]), n2[r]), std::min(n3[r], n4[r]));
    const std::uint16_t own_far = std::max(std::max(std::max(f0[r], f1[r]), f2[r]), std::max(f3[r], f4[r]));
    // Nothing passes below the lowest beam, and nothing is known beyond the reach of one.
    const std::uint16_t known = std::min(far_below[r], std::max(far_above[r], own_far));
    const std::uint16_t unknown = known > 0 ? 0 : 0xFFFF;
    const std::uint32_t nearest = std::min(own_near, std::min(near_below[r], near_above[r])) | unknown;
    const std::uint32_t farthest = std::max(own_far, std::max(far_below[r], far_above[r])) & ~unknown;
    spans[r] = nearest | farthest << 16;
  }
}

}  // namespace

ColumnBracket::ColumnBracket(const SphericalGrid& grid, int gap)
    : grid_(grid),
      gap_(gap),
      margin_(static_cast<std::size_t>(std::max(gap, kReach))),
      wide_(padded_rows()),
      below_(padded_rows()),
      above_(padded_rows()),
      before_(padded_rows()) {}

void ColumnBracket::run(const SpanPlanes& planes, int column, std::uint32_t* spans) {
  widen(planes, column);
  look(-1, below_);
  look(1, above_);
  const std::uint16_t *n = &wide_.nearest[margin_], *f = &wide_.farthest[margin_];
  bracket(static_cast<std::size_t>(grid_.rows),
          {n - 2, n - 1, n, n + 1, n + 2, &below_.nearest[margin_ - 1], &above_.nearest[margin_ + 1]},
          {f - 2, f - 1, f, f + 1, f + 2, &below_.farthest[margin_ - 1], &above_.farthest[margin_ + 1]},
          spans);
}

void ColumnBracket::widen(const SpanPlanes& planes, int column) {
  const auto rows = static_cast<std::size_t>(grid_.rows);
  const std::size_t left = static_cast<std::size_t>((column + grid_.columns - 1) % grid_.columns) * rows;
  const std::size_t here = static_cast<std::size_t>(column) * rows;
  const std::size_t right = static_cast<std::size_t>((column + 1) % grid_.columns) * rows;
  const std::uint16_t *n = planes.nearest.data(), *f = planes.farthest.data();
  join_columns(rows, {n + left, n + here, n + right}, {f + left, f + here, f + right},
               &wide_.nearest[margin_], &wide_.farthest[margin_]);
}

// The first return of 1, 2, 4 ... gap rows, made of that of half as many: no row waits for the one before.
void ColumnBracket::look(int step, SpanPlanes& found) {
  found = wide_;
  for (int known = 1; known < gap_;) {
    const int more = std::min(known, gap_ - known);
    std::swap(found, before_);
    fill_from(step * more, static_cast<std::size_t>(grid_.rows), &before_.nearest[margin_],
              &before_.farthest[margin_], &found.nearest[margin_], &found.farthest[margin_]);
    known += more;
  }
}

}  // namespace stillmap
