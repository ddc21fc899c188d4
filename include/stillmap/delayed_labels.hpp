#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "stillmap/mapper.hpp"

namespace stillmap {

/// Keeps the last scans, and judges each again when the map has seen `delay` more. ScanT is whatever holds a
/// `scan` and its `T_map_sensor`.
template <class ScanT>
class DelayedLabels {
 public:
  struct Settled {
    ScanT scan;
    ScanLabels labels;
  };

  explicit DelayedLabels(std::size_t delay) : delay_(delay) {}

  /// After mapper.process() of this scan, whose labels are `online`: the scan of `delay` scans ago, if any.
  std::optional<Settled> add(const Mapper& mapper, ScanT scan, const ScanLabels& online) {
    if (mapper.scan_count() == 1) clear();  // the map was reset and knows nothing of what was before
    waiting_.push_back({std::move(scan), online});
    if (waiting_.size() <= delay_) return std::nullopt;
    return settle_oldest(mapper);
  }

  /// When no scan follows: the oldest of those that still wait, judged by what there is.
  std::optional<Settled> settle_oldest(const Mapper& mapper) {
    if (waiting_.empty()) return std::nullopt;
    Settled settled = std::move(waiting_.front());
    waiting_.pop_front();
    settled.labels = mapper.relabel(settled.scan.scan, settled.scan.T_map_sensor, settled.labels);
    return settled;
  }

  void clear() { waiting_.clear(); }

 private:
  std::size_t delay_;
  std::deque<Settled> waiting_;  ///< with the labels of their own time
};

}  // namespace stillmap
