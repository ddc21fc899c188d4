#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Core>
#include <algorithm>
#include <boost/make_shared.hpp>
#include <cstring>
#include <string>
#include <vector>

namespace stillmap {

inline sensor_msgs::PointField make_field(const std::string& name, std::uint32_t offset,
                                          std::uint8_t datatype) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = datatype;
  field.count = 1;
  return field;
}

/// x, y, z as Float, ring as uint16, and three bytes of padding that also must survive.
template <class Float = float>
sensor_msgs::PointCloud2Ptr make_cloud(const std::vector<Eigen::Vector3d>& points,
                                       std::uint64_t stamp_ns = 1) {
  using sensor_msgs::PointField;
  constexpr std::uint8_t type = sizeof(Float) == 4 ? PointField::FLOAT32 : PointField::FLOAT64;
  constexpr std::uint32_t size = sizeof(Float);
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header.stamp.fromNSec(stamp_ns);
  cloud->header.frame_id = "camera_init";
  cloud->fields = {make_field("x", 0, type), make_field("y", size, type), make_field("z", 2 * size, type),
                   make_field("ring", 3 * size, PointField::UINT16)};
  cloud->point_step = 3 * size + 5;
  cloud->height = 1;
  cloud->width = static_cast<std::uint32_t>(points.size());
  cloud->row_step = cloud->width * cloud->point_step;
  cloud->data.resize(cloud->row_step);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint8_t* row = cloud->data.data() + i * cloud->point_step;
    for (int axis = 0; axis < 3; ++axis) {
      const auto value = static_cast<Float>(points[i][axis]);
      std::memcpy(row + axis * size, &value, size);
    }
    const auto ring = static_cast<std::uint16_t>(i);
    std::memcpy(row + 3 * size, &ring, sizeof(ring));
    std::fill_n(row + 3 * size + 2, 3, static_cast<std::uint8_t>(0xA0 + i));
  }
  return cloud;
}

/// Turns the bytes of x, y, z and ring around, as a big-endian machine would write them.
inline void make_bigendian(sensor_msgs::PointCloud2& cloud) {
  cloud.is_bigendian = true;
  for (std::size_t i = 0; i < cloud.width; ++i)
    for (const auto& field : cloud.fields) {
      const std::size_t size = field.datatype == sensor_msgs::PointField::FLOAT64   ? 8
                               : field.datatype == sensor_msgs::PointField::FLOAT32 ? 4
                                                                                    : 2;
      std::uint8_t* value = cloud.data.data() + i * cloud.point_step + field.offset;
      std::reverse(value, value + size);
    }
}

}  // namespace stillmap
