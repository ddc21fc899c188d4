#include "scan_history.hpp"

#include <algorithm>
#include <limits>

namespace stillmap {

void ScanHistory::add(ScanView view) {
  constexpr double kTimeAsWayM = 0.05;  // so that scans of a standing sensor are spread over time
  if (recent_limit_ + spread_limit_ == 0) return;
  if (!recent_.empty())
    travelled_m_ += std::max(kTimeAsWayM, (view.origin_map_m - recent_.back().view.origin_map_m).norm());
  recent_.push_back({std::move(view), travelled_m_});
  if (recent_.size() <= recent_limit_) return;
  spread_.push_back(std::move(recent_.front()));
  recent_.pop_front();
  if (spread_.size() > spread_limit_) thin();
}

void ScanHistory::thin() {
  // The scan whose loss leaves the smallest gap, as seen from here: gaps may grow with the distance.
  constexpr double kNearM = 5.0;
  std::size_t least = 0;
  double least_gap = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < spread_.size(); ++i) {
    const double before = i > 0 ? spread_[i - 1].travelled_m : spread_[i].travelled_m - kNearM;
    const double after = i + 1 < spread_.size() ? spread_[i + 1].travelled_m
                         : recent_.empty()      ? travelled_m_
                                                : recent_.front().travelled_m;
    const double gap = (after - before) / (kNearM + travelled_m_ - spread_[i].travelled_m);
    if (gap < least_gap) {
      least_gap = gap;
      least = i;
    }
  }
  spread_.erase(spread_.begin() + static_cast<std::ptrdiff_t>(least));
}

void ScanHistory::clear() {
  recent_.clear();
  spread_.clear();
  travelled_m_ = 0;
}

}  // namespace stillmap
