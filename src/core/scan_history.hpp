#pragma once

#include <deque>
#include <vector>

#include "scan_view.hpp"

namespace stillmap {

/// The earlier scans that judge a new voxel: the newest ones, and older ones spread over the way that was
/// travelled, dense near the sensor's place and thin far from it.
class ScanHistory {
 public:
  ScanHistory(int recent, int spread) : recent_limit_(recent), spread_limit_(spread) {}

  void add(ScanView view);
  void clear();

  /// Oldest first.
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    for (const Entry& entry : spread_) visit(entry.view);
    for (const Entry& entry : recent_) visit(entry.view);
  }
  template <class Visitor>
  void for_each(Visitor&& visit) {
    for (Entry& entry : spread_) visit(entry.view);
    for (Entry& entry : recent_) visit(entry.view);
  }
  /// The scan `age` scans before the next one to be added (1 = the newest), or nullptr.
  const ScanView* recent(std::size_t age) const {
    return age <= recent_.size() && age > 0 ? &recent_[recent_.size() - age].view : nullptr;
  }
  std::size_t size() const { return spread_.size() + recent_.size(); }

 private:
  struct Entry {
    ScanView view;
    double travelled_m;  ///< on the whole way; a standing sensor "travels" a little with each scan
  };
  void thin();

  std::size_t recent_limit_, spread_limit_;
  double travelled_m_ = 0;
  std::deque<Entry> recent_;
  std::vector<Entry> spread_;
};

}  // namespace stillmap
