#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "stillmap/projection.hpp"

namespace stillmap {

/// The rows of a scan turned upright: from the sensor, along the axes of the map, of which z is up.
struct UprightRows {
  std::vector<float> x_m, y_m, z_m;
  std::vector<std::int16_t>
      ground_cell;  ///< of Ground, below or above the row; -1 beyond its last ring, and without return

  void turn(const ProjectedScan& scan, const Eigen::Matrix3f& R_map_sensor);
};

/// The ground around the sensor in one scan, found by walking outward from it in sectors.
class Ground {
 public:
  static constexpr int kSectors = 120;
  static constexpr int kRings = 100;
  static constexpr float kRingM = 1.0F;

  void fit(const UprightRows& rows);

  /// Height of each row above the ground below it; infinite beyond the last ring.
  void heights_above(const UprightRows& rows, std::vector<float>& height_m) const;
  /// Height of the ground in a cell, as the returns left and right of it show: where a foot alone was hit, it
  /// is taken for the ground.
  float height_beside_m(int cell) const;

 private:
  struct Step {
    int ring;
    float height_m;
  };

  float seed_height() const;
  void walk(int sector, float seed);
  void forget_bump();
  static float between(const Step& a, const Step& b, int ring);
  void settle_on_returns(const UprightRows& rows);
  /// Of the next two cells of a ring with returns close to the ground, `step` sectors at a time, the lower
  /// one; or -1.
  int lower_beside(int sector, int ring, int step) const;

  std::vector<float> lowest_, highest_;  ///< per sector and ring; kNothing and -kNothing = no return
  std::vector<float> height_;            ///< of the ground, for all of them
  std::vector<float> sum_, count_;       ///< of the returns that lie close to it
  std::vector<Step> steps_;              ///< of the present sector: where the walk met ground
};

}  // namespace stillmap
