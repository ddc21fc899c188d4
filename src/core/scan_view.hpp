#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "stillmap/evidence.hpp"
#include "stillmap/range_image.hpp"

namespace stillmap {

/// A scan as the evidence needs it: its pose and its range images at all angular levels.
class ScanView {
 public:
  ScanView(std::uint32_t scan_index, const Eigen::Isometry3d& T_map_sensor, std::vector<RangeImage> levels)
      : scan_index(scan_index),
        origin_map_m(T_map_sensor.translation()),
        R_sensor_map(T_map_sensor.linear().transpose().cast<float>()),
        levels_(std::move(levels)) {}

  /// Into the sensor frame; the subtraction is in double, so maps may be kilometres long.
  Eigen::Vector3f to_sensor(const Eigen::Vector3d& point_map_m) const {
    return R_sensor_map * (point_map_m - origin_map_m).cast<float>();
  }

  /// The same scan from a corrected place.
  void move(const Eigen::Isometry3d& T_new_old) {
    origin_map_m = T_new_old * origin_map_m;
    R_sensor_map = (R_sensor_map.cast<double>() * T_new_old.linear().transpose()).cast<float>();
  }

  /// The evidence of this scan about an element at `point_sensor_m`, all levels fused.
  FusedEvidence evidence(const Eigen::Vector3f& point_sensor_m, const std::vector<LevelModel>& models) const {
    return evidence(spherical(point_sensor_m), models);
  }
  FusedEvidence evidence(const Spherical& s, const std::vector<LevelModel>& models) const {
    FusedEvidence fused;
    for (std::size_t r = 0; r < levels_.size(); ++r) {
      const MeasuredRange measured = levels_[r].at(s.azimuth_rad, s.elevation_rad);
      fused.add(classify(s.range_m, measured, models[r]), s.range_m, measured, models[r]);
    }
    return fused;
  }

  /// For n elements at once: told[i] is kConflict, or LevelModel::support_rank of the strongest support, or 0
  /// where evidence() would be kUnknown.
  static constexpr int kConflict = 0x7FFFFFFF;
  void find_told(std::size_t n, const float* azimuth_rad, const float* elevation_rad, const float* range_m,
                 const std::vector<LevelModel>& models, int* told) const;

  const std::vector<RangeImage>& levels() const { return levels_; }

  std::uint32_t scan_index;  ///< among those of its sensor
  std::int64_t stamp_ns = 0;
  std::size_t sensor = 0;  ///< that took it
  Eigen::Vector3d origin_map_m;
  Eigen::Matrix3f R_sensor_map;

 private:
  std::vector<RangeImage> levels_;
};

}  // namespace stillmap
