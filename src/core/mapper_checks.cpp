#include "mapper_checks.hpp"

#include <sstream>
#include <stdexcept>

#include "stillmap/voxel_key.hpp"

namespace stillmap {

void require_valid(const Parameters& parameters) {
  const std::vector<std::string> found = problems(parameters);
  if (found.empty()) return;
  std::ostringstream text;
  for (const std::string& problem : found) text << (text.tellp() > 0 ? "; " : "") << problem;
  throw std::invalid_argument(text.str());
}

void require_usable(const Eigen::Isometry3d& T_map_sensor, double voxel_size_m) {
  const Eigen::Matrix3d R = T_map_sensor.linear();
  if (!T_map_sensor.matrix().allFinite())
    throw std::invalid_argument("T_map_sensor: not finite; the scan is not used");
  if (!(R * R.transpose()).isIdentity(1e-3) || R.determinant() < 0)
    throw std::invalid_argument("T_map_sensor: its rotation is not a rotation matrix; the scan is not used");
  const double reach_m = kVoxelKeyLimit * voxel_size_m;
  if (T_map_sensor.translation().cwiseAbs().maxCoeff() > reach_m) {
    std::ostringstream text;
    text << "T_map_sensor: (" << T_map_sensor.translation().transpose()
         << ") m is farther from the origin than the " << reach_m
         << " m that a map of this voxel_size_m reaches; the scan is not used. Has the odometry failed?";
    throw std::invalid_argument(text.str());
  }
}

void require_sensor(int sensor) {
  constexpr int kMostSensors = 16;
  if (sensor < 0 || sensor >= kMostSensors)
    throw std::invalid_argument("scan of sensor " + std::to_string(sensor) + ": number them from 0 to " +
                                std::to_string(kMostSensors - 1) + "; the scan is not used");
}

}  // namespace stillmap
