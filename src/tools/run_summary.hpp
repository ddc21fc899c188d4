#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "stillmap/mapper.hpp"

namespace stillmap {

/// CPU time (all threads) and wall time of the engine alone.
class EngineClock : public StageListener {
 public:
  /// `others_cpu_ms` is what threads beside the engine have taken so far: it is left out.
  explicit EngineClock(std::function<double()> others_cpu_ms = nullptr)
      : others_cpu_ms_(std::move(others_cpu_ms)) {}
  void start_scan();
  void end_scan();
  void stage_ended(Stage stage) override;

  const std::vector<double>& cpu_ms() const { return cpu_ms_; }
  const std::vector<double>& wall_ms() const { return wall_ms_; }
  const std::array<double, kStageCount>& stage_cpu_ms() const { return stage_cpu_ms_; }  ///< all scans

 private:
  double cpu_now_ms() const;

  std::function<double()> others_cpu_ms_;
  double scan_cpu_ms_ = 0, scan_wall_ms_ = 0, stage_began_ms_ = 0;
  std::vector<double> cpu_ms_, wall_ms_;
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
