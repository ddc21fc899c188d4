#include "cluster_links.hpp"

#include "vector_clones.hpp"

namespace stillmap {
namespace {

constexpr unsigned step_bit(int columns, int rows) {
  for (std::size_t k = 0; k < kPixelSteps.size(); ++k)
    if (kPixelSteps[k].columns == columns && kPixelSteps[k].rows == rows) return 1U << k;
  return 0;
}
constexpr unsigned kUp = step_bit(0, 1), kTwoUp = step_bit(0, 2), kBeside = step_bit(1, 0);

/// Of the links of a pixel that lies one `step` away: those that lead where a link of this pixel leads, too,
/// which is `shift` bits higher.
constexpr unsigned same_target(PixelStep step, int shift) {
  unsigned steps = 0;
  for (std::size_t k = 0; k < kPixelSteps.size(); ++k) {
    const unsigned here = step_bit(kPixelSteps[k].columns + step.columns, kPixelSteps[k].rows + step.rows);
    steps |= here != 0 && here == 1U << (k + static_cast<std::size_t>(shift)) ? 1U << k : 0U;
  }
  return steps;
}

}  // namespace

STILLMAP_VECTOR_CLONES void link_pixels(std::size_t n, const PixelReturns here, const PixelReturns there,
                                        float reach_per_m, std::uint16_t bit,
                                        std::uint16_t* __restrict links) {
  for (std::size_t i = 0; i < n; ++i) {
    const bool linked =
        together(here.x_m[i] - there.x_m[i], here.y_m[i] - there.y_m[i], here.z_m[i] - there.z_m[i],
                 std::min(here.range_m[i], there.range_m[i]), reach_per_m);
    links[i] = static_cast<std::uint16_t>(links[i] | (linked ? bit : 0));
  }
}

// Each pixel in turn, before those that it looks at are thinned: what is taken away is connected by links
// that go less far, or start higher up.
void thin_links(int low, int high, int rows, std::uint16_t* links, const std::uint16_t* next) {
  constexpr unsigned kByUp = same_target({0, 1}, 1), kByTwoUp = same_target({0, 2}, 2);
  constexpr unsigned kByBeside = same_target({1, 0}, 4);
  for (int i = low; i < high; ++i) {
    const unsigned own = links[i];
    unsigned spare = 0;
    if ((own & kUp) != 0) spare |= (links[std::min(i + 1, rows - 1)] & kByUp) << 1;
    if ((own & kTwoUp) != 0) spare |= (links[std::min(i + 2, rows - 1)] & kByTwoUp) << 2;
    if (next != links && (own & kBeside) != 0) spare |= (next[i] & kByBeside) << 4;
    links[i] = static_cast<std::uint16_t>(own & ~spare);
  }
}

}  // namespace stillmap
