#pragma once

#include <functional>
#include <string>
#include <vector>

#include "simulation/cast_scan.hpp"
#include "simulation/world.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap::simulation {

/// A scan with its truth and what the mapper said at once.
struct JudgedScan {
  SimulatedFrame truth;
  ScanLabels online;
};

/// As shipped, but for the threads: labels do not depend on them, and ThreadSanitizer looks into every world
/// so.
inline Parameters on_two_threads() {
  Parameters parameters;
  parameters.threads = 2;
  return parameters;
}

struct RunOptions {
  std::string sensor = "vlp16";
  int scans = 40;  ///< the first at 0 s
  ReturnNoise noise = {};
  double pose_noise_m = 0.01, pose_noise_deg = 0.05, drift_percent = 0.2;
  double scan_rate_hz = 10;
  std::function<void(int scan)> after_scan = {};
};

/// Drives the sensor through the world and has the mapper judge each scan.
std::vector<JudgedScan> run(Mapper* mapper, const World& world, const SensorMotion& motion,
                            const RunOptions& options);
/// With a mapper of its own.
std::vector<JudgedScan> run(const World& world, const SensorMotion& motion, const RunOptions& options);

/// A sensor that stands, or goes straight along x from (0, 0).
SensorMotion standing_at(double x, double y, double height_m);
SensorMotion driving(double speed_mps, double height_m);

/// Which rows count, by their true label (of the moment: what has not moved yet stands).
using Kind = std::function<bool(std::uint32_t label_now)>;
bool is_moving(std::uint32_t label);
bool is_standing(std::uint32_t label);
Kind of_class(std::uint16_t semantic_class);

/// Percent of the rows of this kind that were labelled `label`; of scans [from, to).
double percent(const std::vector<JudgedScan>& scans, std::size_t from, std::size_t to, const Kind& kind,
               Label label);
double percent(const JudgedScan& scan, const Kind& kind, Label label);
/// Percent of the rows of this kind that the map, as it is now, does not call dynamic.
double percent_kept(const Mapper& mapper, const std::vector<JudgedScan>& scans, const Kind& kind);

inline Eigen::AlignedBox3d box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return {low, high};
}
/// Percent of the map's voxels with their centre in the box that have this label; -1 if there is none.
double percent_of_voxels(const Mapper& mapper, const Eigen::AlignedBox3d& box, Label label);

/// Prints a measured value and returns it.
double measured(const std::string& what, double value);

}  // namespace stillmap::simulation
