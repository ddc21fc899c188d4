#pragma once

#include <cmath>
#include <cstdio>
#include <vector>

#include "io/sequence.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {

/// A sensor with 16 rings drives through a room (walls at |x|, |y| = 8 m, floor and ceiling at |z| = 2 m),
/// and a post crosses its view. Row 0 is no return, row 1 is not a number.
inline Frame room_frame(std::size_t k) {
  const double pi = std::acos(-1.0);
  const Eigen::Vector3d origin(0.1 * static_cast<double>(k), 0, 0),
      post(4.0, 2.0 - 0.5 * static_cast<double>(k), 0);
  Frame frame;
  char name[16];
  std::snprintf(name, sizeof(name), "%06zu", k);
  frame.name = name;
  frame.scan.stamp_ns = static_cast<std::int64_t>(k) * 100'000'000;
  frame.T_map_sensor.translation() = origin;
  frame.scan.points = {Eigen::Vector3f::Zero(), Eigen::Vector3f::Constant(std::nanf(""))};
  for (int ring = 0; ring < 16; ++ring)
    for (int step = 0; step < 720; ++step) {
      const double elevation = (2.0 * ring - 15.0) * pi / 180.0, azimuth = 0.5 * step * pi / 180.0;
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      double range_m = 1e9;
      for (int axis = 0; axis < 3; ++axis)
        range_m = std::min(range_m, ((axis == 2 ? 2.0 : 8.0) - std::copysign(origin[axis], ray[axis])) /
                                        std::max(1e-9, std::abs(ray[axis])));
      const Eigen::Vector2d flat = ray.head<2>().normalized(), to_post = (post - origin).head<2>();
      const double along = flat.dot(to_post);
      if (along > 0 && (to_post - along * flat).norm() < 0.3)
        range_m = std::min(range_m, along / ray.head<2>().norm());
      frame.scan.points.push_back((range_m * ray).cast<float>());
    }
  return frame;
}

/// The room as a folder in SemanticKITTI layout.
inline void write_room_sequence(const TemporaryFolder& folder, std::size_t scans) {
  std::string poses;
  for (std::size_t k = 0; k < scans; ++k) {
    const Frame frame = room_frame(k);
    std::string bytes;
    for (const Eigen::Vector3f& point : frame.scan.points) {
      const float row[4] = {point.x(), point.y(), point.z(), 0.5F};
      bytes.append(reinterpret_cast<const char*>(row), sizeof(row));
    }
    folder.write("velodyne/" + frame.name + ".bin", bytes);
    char line[96];
    std::snprintf(line, sizeof(line), "1 0 0 %.17g 0 1 0 0 0 0 1 0\n", frame.T_map_sensor.translation().x());
    poses += line;
  }
  folder.write("poses.txt", poses);
}

}  // namespace stillmap
