#include "scan_view.hpp"

#include <algorithm>

namespace stillmap {

void ScanView::find_told(std::size_t n, const float* azimuth_rad, const float* elevation_rad,
                         const float* range_m, const std::vector<LevelModel>& models, int* told) const {
  std::fill_n(told, n, 0);
  for (std::size_t r = 0; r < levels_.size(); ++r)
    levels_[r].tell(n, azimuth_rad, elevation_rad, range_m, models[r], models[r].kappa > 0 ? kConflict : 0,
                    models[r].support_rank, told);
}

}  // namespace stillmap
