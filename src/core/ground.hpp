#pragma once

#include <Eigen/Core>
#include <vector>

#include "stillmap/projection.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// The ground around the sensor in one scan, found by walking outward from it in sectors. z of the map is up.
class Ground {
 public:
  /// R_map_sensor turns sensor points upright; heights are relative to the sensor.
  void fit(const Scan& scan, const ProjectedScan& projected, const Eigen::Matrix3f& R_map_sensor);

  /// Height of a point above the ground below it; `upright` is relative to the sensor, axes of the map.
  float height_above(const Eigen::Vector3f& upright) const;

 private:
  static constexpr int kSectors = 120;
  static constexpr int kRings = 100;
  static constexpr float kRingM = 1.0F;

  static int cell_of(const Eigen::Vector3f& upright);  ///< -1 beyond the last ring
  float seed_height() const;
  void walk(int sector, float seed);
  void settle_on_returns(const Scan& scan, const ProjectedScan& projected,
                         const Eigen::Matrix3f& R_map_sensor);

  std::vector<float> lowest_;  ///< per sector and ring; kNothing = no return
  std::vector<float> height_;  ///< of the ground, for all of them
  std::vector<float> sum_, count_;
};

}  // namespace stillmap
