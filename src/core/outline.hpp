#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillmap {

/// An object as it is seen from the sensor: the directions that it covers, its extent and how far away it is.
class Outline {
 public:
  /// One return of it; x and y along the axes of the map.
  void add(float azimuth_rad, float elevation_rad, float range_m, float x_m, float y_m) {
    if (rows_++ == 0) start_rad_ = azimuth_rad;
    azimuth_rad_.add(turned(azimuth_rad));
    elevation_rad_.add(elevation_rad);
    x_m_.add(x_m);
    y_m_.add(y_m);
    range_sum_m_ += range_m;
  }

  int rows() const { return rows_; }
  float length_m() const { return std::hypot(x_m_.extent(), y_m_.extent()); }
  /// Whether a return lies in its directions, from right before its mean range to depth_m behind it.
  bool holds(float azimuth_rad, float elevation_rad, float range_m, float depth_m) const {
    constexpr float kBeforeM = 0.5F;
    const float behind_m = range_m - range_sum_m_ / static_cast<float>(rows_);
    return behind_m > -kBeforeM && behind_m < depth_m && elevation_rad_.has(elevation_rad) &&
           azimuth_rad_.has(turned(azimuth_rad));
  }

 private:
  struct Interval {
    float from = std::numeric_limits<float>::infinity(), to = -std::numeric_limits<float>::infinity();
    void add(float value) {
      from = std::min(from, value);
      to = std::max(to, value);
    }
    float extent() const { return to - from; }
    bool has(float value) const { return value >= from && value <= to; }
  };
  /// From its first return, within half a turn.
  float turned(float azimuth_rad) const {
    constexpr float kTurn = 6.28318531F;
    return std::remainder(azimuth_rad - start_rad_, kTurn);
  }

  Interval azimuth_rad_, elevation_rad_, x_m_, y_m_;
  float start_rad_ = 0, range_sum_m_ = 0;
  int rows_ = 0;
};

}  // namespace stillmap
