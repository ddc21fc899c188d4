#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

namespace stillmap {

/// As text: messages of roscpp 1.14 cannot be compared.
inline std::vector<std::string> fields_of(const sensor_msgs::PointCloud2& cloud) {
  std::vector<std::string> fields;
  for (const sensor_msgs::PointField& field : cloud.fields)
    fields.push_back(field.name + " " + std::to_string(field.offset) + " " + std::to_string(field.datatype) +
                     " " + std::to_string(field.count));
  return fields;
}

}  // namespace stillmap
