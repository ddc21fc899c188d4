#include "messages/point_cloud_conversion.hpp"

#include <boost/endian/conversion.hpp>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>

namespace stillmap {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw std::runtime_error(text.str());
}

void check_layout(const PointCloud2& cloud) {
  const std::uint64_t row_bytes = std::uint64_t(cloud.width) * cloud.point_step;
  if (cloud.height > 1 && cloud.row_step < row_bytes)
    refuse("row_step is ", cloud.row_step, " but ", cloud.width, " points of ", cloud.point_step,
           " bytes need ", row_bytes, ": the publisher must fill in row_step");
  const std::uint64_t needed = std::uint64_t(cloud.height - 1) * cloud.row_step + row_bytes;
  if (cloud.data.size() < needed)
    refuse("data holds ", cloud.data.size(), " bytes but ", cloud.width, " x ", cloud.height, " points need ",
           needed, ": the message was cut off or is filled in wrongly by its publisher");
}

std::string field_names(const PointCloud2& cloud) {
  std::string names;
  for (const PointField& field : cloud.fields) names += (names.empty() ? "" : ", ") + field.name;
  return names.empty() ? "none" : names;
}

const PointField& find_coordinate(const PointCloud2& cloud, const std::string& name) {
  for (const PointField& field : cloud.fields) {
    if (field.name != name) continue;
    if (field.datatype != PointField::FLOAT32 && field.datatype != PointField::FLOAT64)
      refuse("field '", name, "' has datatype ", int(field.datatype),
             "; publish x, y, z as FLOAT32 (7) or FLOAT64 (8)");
    const std::size_t size = field.datatype == PointField::FLOAT32 ? 4 : 8;
    if (field.offset + size > cloud.point_step)
      refuse("field '", name, "' at offset ", field.offset, " reaches past point_step ", cloud.point_step,
             ": the publisher must fill in the offsets");
    return field;
  }
  refuse("there is no field '", name, "' (fields: ", field_names(cloud),
         "); the cloud must have x, y and z in metres");
}

template <class Float, class Bits>
float read_as(const std::uint8_t* bytes, bool is_bigendian) {
  Bits bits;
  std::memcpy(&bits, bytes, sizeof(bits));
  bits = is_bigendian ? boost::endian::big_to_native(bits) : boost::endian::little_to_native(bits);
  Float value;
  std::memcpy(&value, &bits, sizeof(value));
  return static_cast<float>(value);
}

struct Coordinate {
  std::size_t offset;
  bool is_double, is_bigendian;

  Coordinate(const PointCloud2& cloud, const std::string& name) : is_bigendian(cloud.is_bigendian) {
    const PointField& field = find_coordinate(cloud, name);
    offset = field.offset;
    is_double = field.datatype == PointField::FLOAT64;
  }
  float read(const std::uint8_t* row) const {
    return is_double ? read_as<double, std::uint64_t>(row + offset, is_bigendian)
                     : read_as<float, std::uint32_t>(row + offset, is_bigendian);
  }
};

}  // namespace

void to_scan(const PointCloud2& cloud, Scan& scan) {
  scan.stamp_ns = static_cast<std::int64_t>(cloud.header.stamp.toNSec());
  const std::size_t rows = row_count(cloud);
  scan.points.clear();
  if (rows == 0) return;
  check_layout(cloud);
  const Coordinate x(cloud, "x"), y(cloud, "y"), z(cloud, "z");
  scan.points.reserve(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::uint8_t* row = row_data(cloud, i);
    scan.points.emplace_back(x.read(row), y.read(row), z.read(row));
  }
}

}  // namespace stillmap
