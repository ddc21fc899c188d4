#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstddef>
#include <cstdint>

#include "stillmap/types.hpp"

namespace stillmap {

/// Rows of the cloud, whatever their arrangement.
inline std::size_t row_count(const sensor_msgs::PointCloud2& cloud) {
  return std::size_t(cloud.width) * cloud.height;
}

/// Start of row i; rows of an image-like cloud may be padded.
inline const std::uint8_t* row_data(const sensor_msgs::PointCloud2& cloud, std::size_t i) {
  return cloud.data.data() + (i / cloud.width) * cloud.row_step + (i % cloud.width) * cloud.point_step;
}

/// Row i of the cloud becomes point i, in the cloud's own frame: x, y, z as float32 or float64 of either byte
/// order. Throws std::runtime_error naming the field or size that is wrong, and what to do.
void to_scan(const sensor_msgs::PointCloud2& cloud, Scan& scan);

}  // namespace stillmap
