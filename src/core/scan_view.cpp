#include "scan_view.hpp"

#include <algorithm>

#include "vector_clones.hpp"

namespace stillmap {
namespace {

/// Marks the elements that a level supports or contradicts; see classify().
STILLMAP_VECTOR_CLONES void mark_told(std::size_t n, const float* __restrict range_m,
                                      const float* __restrict nearest_m, const float* __restrict farthest_m,
                                      const LevelModel& model, std::uint8_t* __restrict told) {
  const LevelModel level = model;
  for (std::size_t i = 0; i < n; ++i) {
    const Evidence evidence = classify(range_m[i], {nearest_m[i], farthest_m[i]}, level);
    told[i] |= static_cast<std::uint8_t>(evidence == Evidence::kConflict || evidence == Evidence::kSupport);
  }
}

}  // namespace

void ScanView::find_told(std::size_t n, const float* azimuth_rad, const float* elevation_rad,
                         const float* range_m, const std::vector<LevelModel>& models,
                         std::uint8_t* told) const {
  constexpr std::size_t kAtOnce = 512;
  float nearest_m[kAtOnce], farthest_m[kAtOnce];
  std::fill_n(told, n, std::uint8_t{0});
  for (std::size_t first = 0; first < n; first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, n - first);
    for (std::size_t r = 0; r < levels_.size(); ++r) {
      levels_[r].at(count, azimuth_rad + first, elevation_rad + first, nearest_m, farthest_m);
      mark_told(count, range_m + first, nearest_m, farthest_m, models[r], told + first);
    }
  }
}

}  // namespace stillmap
