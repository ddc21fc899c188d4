#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace stillmap {

/// A neighbour of a pixel, ahead of it; the one behind finds it in turn.
struct PixelStep {
  int columns, rows;
};
inline constexpr std::array<PixelStep, 10> kPixelSteps = {
    {{0, 1}, {0, 2}, {1, -2}, {1, -1}, {1, 0}, {1, 1}, {1, 2}, {2, -1}, {2, 0}, {2, 1}}};
inline constexpr unsigned kEveryStep = (1U << kPixelSteps.size()) - 1;

/// The steps, as bits, that go no farther than so many columns.
constexpr unsigned steps_within(int columns) {
  unsigned steps = 0;
  for (std::size_t k = 0; k < kPixelSteps.size(); ++k)
    steps |= kPixelSteps[k].columns <= columns ? 1U << k : 0U;
  return steps;
}

/// The nearest returns of some pixels of a column, one coordinate after the other.
struct PixelReturns {
  const float *x_m, *y_m, *z_m, *range_m;
};

/// How far apart two returns of one surface may lie.
inline float reach_m(float nearer_range_m, float reach_per_m) {
  return 0.25F + reach_per_m * nearer_range_m;
}
/// Two returns are one surface; NaN never is.
inline bool together(float dx, float dy, float dz, float nearer_range_m, float reach_per_m) {
  const float reach = reach_m(nearer_range_m, reach_per_m);
  return dx * dx + (dy * dy + dz * dz) <= reach * reach;
}

/// Sets `bit` in the links of each of n pixels that is one surface with its neighbour.
void link_pixels(std::size_t n, PixelReturns here, PixelReturns there, float reach_per_m, std::uint16_t bit,
                 std::uint16_t* links);

/// Takes away links between pixels that other links connect anyway: of pixels low .. high - 1 of a column of
/// `rows`. `next` are the links of the next column, or the column's own for none.
void thin_links(int low, int high, int rows, std::uint16_t* links, const std::uint16_t* next);

}  // namespace stillmap
