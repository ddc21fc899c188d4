#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "input.hpp"

namespace stillmap::fuzz {

/// A cloud in which everything may be wrong. Sizes are mostly small, so that some clouds are right.
inline sensor_msgs::PointCloud2 take_cloud(Input& in) {
  const auto size = [&]() -> std::uint32_t {
    const auto small = in.take<std::uint8_t>();
    return small < 250 ? small : in.take<std::uint32_t>();
  };
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp.sec = size();
  cloud.header.stamp.nsec = in.take<std::uint32_t>() % 1'000'000'000;
  cloud.width = size();
  cloud.height = size();
  cloud.point_step = size();
  cloud.row_step = size();
  const auto flags = in.take<std::uint8_t>();
  cloud.is_bigendian = flags & 1;
  cloud.is_dense = flags >> 1 & 1;
  const std::size_t fields = in.choose(8);
  static const char* const names[] = {"x", "y", "z", "intensity", "label", "p_static", "reason", ""};
  for (std::size_t f = 0; f < fields; ++f) {
    sensor_msgs::PointField& field = cloud.fields.emplace_back();
    field.name = names[in.choose(8)];
    field.offset = size();
    field.datatype = in.take<std::uint8_t>() % 12;
    field.count = size();
  }
  const std::string data = in.take_text(flags & 4 ? size() : 1 << 20);
  cloud.data.assign(data.begin(), data.end());
  return cloud;
}

}  // namespace stillmap::fuzz
