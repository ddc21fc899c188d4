#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "io/sequence.hpp"
#include "simulation/shape.hpp"

namespace stillmap {

/// Boxes on flat ground at z = 0.
struct SmallWorld {
  std::vector<simulation::Shape> boxes;

  void add_box(const Eigen::Vector3d& lowest, const Eigen::Vector3d& highest) {
    const Eigen::Vector3d middle = 0.5 * (lowest + highest);
    boxes.push_back(simulation::make_box(simulation::pose_at(middle.x(), middle.y(), middle.z()),
                                         highest - lowest, simulation::surfaces::kMetal));
  }

  /// What a sensor at `origin` measures with a ray every `step_deg` up to 30 m, row by row from -24 degrees.
  Frame scan(const Eigen::Vector3d& origin, double step_deg = 0.5) const {
    Frame frame;
    frame.T_map_sensor.translation() = origin;
    const double rad = M_PI / 180.0;
    for (double elevation = -24.0; elevation <= 10.0; elevation += step_deg)
      for (double azimuth = -180.0; azimuth < 180.0; azimuth += step_deg) {
        const Eigen::Vector3d direction(std::cos(elevation * rad) * std::cos(azimuth * rad),
                                        std::cos(elevation * rad) * std::sin(azimuth * rad),
                                        std::sin(elevation * rad));
        double range_m = direction.z() < 0 ? -origin.z() / direction.z() : std::numeric_limits<double>::max();
        for (const simulation::Shape& box : boxes)
          if (const auto crossing = box.cross({origin, direction}))
            range_m = std::min(range_m, crossing->range_m);
        if (range_m < 30) frame.scan.points.push_back((range_m * direction).cast<float>());
      }
    return frame;
  }
};

inline bool is_inside(const Frame& frame, std::size_t row, const Eigen::Vector3d& lowest,
                      const Eigen::Vector3d& highest) {
  const Eigen::Vector3d point = frame.T_map_sensor * frame.scan.points[row].cast<double>();
  return (point.array() >= lowest.array() - 0.01).all() && (point.array() <= highest.array() + 0.01).all();
}

}  // namespace stillmap
