#pragma once

#include <map>
#include <string>
#include <vector>

#include "baselines/removal_method.hpp"
#include "evaluation/confusion.hpp"
#include "evaluation/probability_histogram.hpp"

namespace stillmap {

/// What happened to one moving object.
struct ObjectScore {
  std::size_t points = 0, removed = 0;          ///< over all scans; removed = judged dynamic
  std::size_t first_scan = 0;                   ///< that shows it moving
  std::optional<std::size_t> first_scan_found;  ///< in which at least half of it is judged dynamic

  std::optional<std::size_t> delay_scans() const {
    if (!first_scan_found) return std::nullopt;
    return *first_scan_found - first_scan;
  }
};

/// Delay until half of an object is flagged, over the objects that appear after the first scan.
struct DelaySummary {
  std::size_t objects = 0, never = 0;
  std::optional<double> median_scans;  ///< never counts as longer than any; nothing if the median is never
};

/// The figures of one pass over a sequence: all verdicts at once, or all final ones.
class PassScore {
 public:
  /// Bands of range: 0 to 10, 10 to 30, 30 to 50 m, and beyond.
  static constexpr std::array<const char*, 4> kRangeBands = {"0 to 10 m", "10 to 30 m", "30 to 50 m",
                                                             "beyond 50 m"};

  /// Throws std::runtime_error when there is not one verdict and one label for each row.
  void add(const Frame& frame, const std::vector<std::uint32_t>& truth, const PointVerdicts& verdicts);

  const Confusion& total() const { return total_; }
  const std::vector<Confusion>& scans() const { return scans_; }
  const std::map<std::uint16_t, Confusion>& classes() const { return classes_; }  ///< by semantic class
  const std::array<Confusion, kRangeBands.size()>& ranges() const { return ranges_; }
  const std::map<std::uint32_t, ObjectScore>& objects() const { return objects_; }  ///< by label
  const ProbabilityHistogram& probabilities() const { return probabilities_; }
  const std::map<Reason, ProbabilityHistogram>& reasons() const { return reasons_; }  ///< where given
  Percent vegetation_kept(Uncertain uncertain) const;
  DelaySummary delay() const;

 private:
  void add_objects(const std::vector<std::uint32_t>& truth, const std::vector<Label>& verdicts);

  Confusion total_;
  std::vector<Confusion> scans_;
  std::map<std::uint16_t, Confusion> classes_;
  std::array<Confusion, kRangeBands.size()> ranges_;
  std::map<std::uint32_t, ObjectScore> objects_;
  ProbabilityHistogram probabilities_;
  std::map<Reason, ProbabilityHistogram> reasons_;
};

}  // namespace stillmap
