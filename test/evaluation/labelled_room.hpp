#pragma once

#include "io/semantickitti_folder.hpp"
#include "tools/room_sequence.hpp"

namespace stillmap {

/// The room with a moving post, with labels: the post is a moving person, walls are building, the floor road.
inline void write_labelled_room(const TemporaryFolder& folder, std::size_t scans) {
  write_room_sequence(folder, scans);
  for (std::size_t k = 0; k < scans; ++k) {
    const Frame frame = room_frame(k);
    std::vector<std::uint32_t> labels;
    for (const Eigen::Vector3f& row : frame.scan.points) {
      const Eigen::Vector3f point = row + frame.T_map_sensor.translation().cast<float>();
      const bool on_wall = point.head<2>().cwiseAbs().maxCoeff() > 7.9F,
                 on_floor = std::abs(point.z()) > 1.9F;
      const bool no_return = !row.allFinite() || row.isZero();
      labels.push_back(no_return ? 0 : on_wall ? 50 : on_floor ? 40 : 254u | 1u << 16);
    }
    folder.write("labels/" + frame.name + ".label",
                 {reinterpret_cast<const char*>(labels.data()), labels.size() * sizeof(std::uint32_t)});
  }
}

}  // namespace stillmap
