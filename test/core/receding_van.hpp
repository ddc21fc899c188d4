#pragma once

#include <cmath>

#include "core/made_scans.hpp"

namespace stillmap {

/// A van 2 m wide, across the view of a standing sensor and driving away from it, before a far wall. One
/// column in four is a window, behind which there is something else in each scan.
struct Van {
  float speed = 0.8F;  // metres a scan
  static constexpr Rings kSensor{64, 1024, -22.5F, 22.5F};
  float back_m(int scan) const { return 6 + speed * static_cast<float>(scan); }
  bool covers(float azimuth, float elevation, int scan) const {
    return std::abs(std::tan(azimuth)) * back_m(scan) < 1 && std::abs(std::tan(elevation)) * back_m(scan) < 1;
  }
  bool is_window(float azimuth, float elevation, int scan) const {
    const int column = static_cast<int>(std::floor(azimuth / (kSensor.step_deg() * kRad)));
    return (column + 1200) % 12 < 3 && std::abs(std::tan(elevation)) * back_m(scan) < 0.7F;
  }
  Scan at(int scan) const {
    Scan made = kSensor.scan([&](float azimuth, float elevation) {
      const float along = std::cos(azimuth) * std::cos(elevation);
      if (!covers(azimuth, elevation, scan)) return 40 / along;
      const float deep_m =
          is_window(azimuth, elevation, scan) ? 1.0F + 0.23F * static_cast<float>(scan * 7 % 5) : 0.0F;
      return (back_m(scan) + deep_m) / along;
    });
    made.stamp_ns = scan * 100'000'000LL;
    return made;
  }
};

}  // namespace stillmap
