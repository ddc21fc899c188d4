#pragma once

#include <optional>
#include <vector>

#include "doctor/finding.hpp"
#include "doctor/frame_readings.hpp"
#include "messages/pairing_options.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// Looks at the first scans for what would ruin the results silently. A reading of the frames can only be
/// judged when the sensor has moved, so that one check may come later.
class Doctor {
 public:
  static constexpr std::size_t kScans = 20;
  explicit Doctor(const PairingOptions& said) : said_(said) {}

  /// The next scan as it was paired, and what became of it. Returns what was found with it, each finding
  /// once.
  std::vector<Finding> add(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                           const LabelCounts& counts);
  bool is_done() const { return frames_are_judged_ && scans_ >= kScans; }
  std::size_t scans() const { return scans_; }

 private:
  void look_at_scan(const Scan& scan, const Eigen::Isometry3d& T_map_sensor, std::vector<Finding>& found);
  void look_at_motion(const Scan& scan, const Eigen::Isometry3d& T_map_sensor, std::vector<Finding>& found);
  void look_at_outcome(const LabelCounts& counts, std::vector<Finding>& found);

  PairingOptions said_;
  std::size_t scans_ = 0;
  std::vector<std::optional<Finding>> first_look_;  ///< of the single-scan checks; a finding needs two
  std::optional<AsSent> reference_;
  bool frames_are_judged_ = false;
  std::size_t dynamic_ = 0, judged_ = 0;
};

}  // namespace stillmap
