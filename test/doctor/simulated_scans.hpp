#pragma once

#include <string>
#include <vector>

#include "doctor/doctor.hpp"

namespace stillmap {

/// A scan in its sensor's frame, and where the sensor was.
struct PlacedScan {
  Scan scan;
  Eigen::Isometry3d T_map_sensor;
};

/// The first scans of a scene, with the noise that an odometry has.
std::vector<PlacedScan> simulated(const std::string& scene, const std::string& sensor, double ego_speed_mps,
                                  std::size_t scans = Doctor::kScans);

/// How a package sends the scans: the truth of PairingOptions.
struct Sent {
  PairingOptions truth;
  bool odometry_stands = false;
};

/// What the doctor finds when the scans are sent so, and `said` is what the node was told: "frames: ...".
std::vector<std::string> findings(const std::vector<PlacedScan>& scans, const Sent& sent,
                                  const PairingOptions& said);

}  // namespace stillmap
