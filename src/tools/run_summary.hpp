#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "stillmap/mapper.hpp"

namespace stillmap {

/// What each scan took.
struct ScanTimes {
  std::vector<double> cpu_ms, wall_ms;
};

/// CPU time (all threads) and wall time of the engine alone.
class EngineClock : public StageListener {
 public:
  /// `others_cpu_ms` is what threads beside the engine have taken so far: it is left out.
  explicit EngineClock(std::function<double()> others_cpu_ms = nullptr)
      : others_cpu_ms_(std::move(others_cpu_ms)) {}
  void start_scan();
  void end_scan();
  void stage_ended(Stage stage) override;

  const ScanTimes& scans() const { return scans_; }
  const ScanTimes& until_labels() const { return until_labels_; }
  const ScanTimes& upkeep() const { return upkeep_; }
  const std::array<double, kStageCount>& stage_cpu_ms() const { return stage_cpu_ms_; }  ///< all scans

 private:
  struct Instant {
    double cpu_ms = 0, wall_ms = 0;
  };
  Instant now() const;
  static void add(ScanTimes& times, const Instant& from, const Instant& to);

  std::function<double()> others_cpu_ms_;
  Instant scan_began_, stage_began_;
  ScanTimes scans_, until_labels_, upkeep_;
  std::array<double, kStageCount> stage_cpu_ms_{};
};

/// Label counts over all scans of a pass.
struct LabelTotals {
  std::size_t scans = 0, points = 0;
  LabelCounts counts;

  void add(const ScanLabels& labels);
};

/// What a run did, beside its times.
struct RunSummary {
  LabelTotals online, delayed, final;
  std::size_t voxels = 0;
};

/// Writes summary.json: results with their conditions.
void write_summary(const std::string& path, const RunSummary& summary, const EngineClock& clock,
                   const Parameters& parameters);

}  // namespace stillmap
