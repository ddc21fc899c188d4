#include "messages/labelled_cloud.hpp"

#include <algorithm>
#include <boost/endian/conversion.hpp>
#include <boost/make_shared.hpp>
#include <cstring>
#include <string>

#include "messages/point_cloud_conversion.hpp"

namespace stillmap {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointCloud2Ptr;
using sensor_msgs::PointField;

// The cloud without its data.
PointCloud2Ptr like(const PointCloud2& cloud) {
  auto out = boost::make_shared<PointCloud2>();
  out->header = cloud.header;
  out->fields = cloud.fields;
  out->is_bigendian = cloud.is_bigendian;
  out->point_step = cloud.point_step;
  out->is_dense = cloud.is_dense;
  return out;
}

bool has_field(const PointCloud2& cloud, const std::string& name) {
  return std::any_of(cloud.fields.begin(), cloud.fields.end(),
                     [&](const PointField& field) { return field.name == name; });
}

void rename_field(PointCloud2& cloud, const std::string& name) {
  std::string free_name = name;
  while (has_field(cloud, free_name)) free_name.insert(0, "input_");
  for (PointField& field : cloud.fields)
    if (field.name == name) field.name = free_name;
}

void add_field(PointCloud2& cloud, const std::string& name, std::uint8_t datatype, std::uint32_t offset) {
  rename_field(cloud, name);
  PointField field;
  field.name = name;
  field.datatype = datatype;
  field.offset = offset;
  field.count = 1;
  cloud.fields.push_back(field);
}

void write_float(std::uint8_t* to, float value, bool is_bigendian) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  bits = is_bigendian ? boost::endian::native_to_big(bits) : boost::endian::native_to_little(bits);
  std::memcpy(to, &bits, sizeof(bits));
}

}  // namespace

PointCloud2Ptr select_rows(const PointCloud2& cloud, const ScanLabels& labels, LabelSet wanted) {
  const auto is_wanted = [=](Label label) { return wanted.contains(label); };
  PointCloud2Ptr out = like(cloud);
  out->height = 1;
  out->width = static_cast<std::uint32_t>(std::count_if(labels.label.begin(), labels.label.end(), is_wanted));
  out->row_step = out->width * out->point_step;
  out->data.resize(out->row_step);
  std::uint8_t* to = out->data.data();
  for (std::size_t i = 0; i < labels.label.size(); ++i) {
    if (!is_wanted(labels.label[i])) continue;
    std::memcpy(to, row_data(cloud, i), cloud.point_step);
    to += cloud.point_step;
  }
  return out;
}

PointCloud2Ptr mask_rows(const PointCloud2& cloud, const ScanLabels& labels, LabelSet unwanted) {
  auto out = boost::make_shared<PointCloud2>(cloud);
  out->is_dense = false;
  for (const PointField& field : cloud.fields) {
    if (field.name != "x" && field.name != "y" && field.name != "z") continue;
    const std::size_t bytes = field.datatype == PointField::FLOAT64 ? sizeof(double) : sizeof(float);
    for (std::size_t i = 0; i < labels.label.size(); ++i) {
      if (!unwanted.contains(labels.label[i])) continue;
      const std::ptrdiff_t row = row_data(cloud, i) - cloud.data.data();
      std::memset(&out->data[static_cast<std::size_t>(row) + field.offset], 0xFF,
                  bytes);  // a NaN either way round
    }
  }
  return out;
}

PointCloud2Ptr add_label_fields(const PointCloud2& cloud, const ScanLabels& labels) {
  const std::uint32_t p_static_at = (cloud.point_step + 3) & ~3u;  // aligned for readers that cast rows
  PointCloud2Ptr out = like(cloud);
  add_field(*out, "p_static", PointField::FLOAT32, p_static_at);
  add_field(*out, "label", PointField::UINT8, p_static_at + 4);
  add_field(*out, "reason", PointField::UINT8, p_static_at + 5);
  out->point_step = p_static_at + 8;
  out->width = cloud.width;
  out->height = cloud.height;
  out->row_step = out->width * out->point_step;
  out->data.resize(std::size_t(out->row_step) * out->height);
  std::uint8_t* to = out->data.data();
  for (std::size_t i = 0; i < labels.label.size(); ++i, to += out->point_step) {
    std::memcpy(to, row_data(cloud, i), cloud.point_step);
    write_float(to + p_static_at, labels.p_static[i], cloud.is_bigendian);
    to[p_static_at + 4] = static_cast<std::uint8_t>(labels.label[i]);
    to[p_static_at + 5] = static_cast<std::uint8_t>(labels.reason[i]);
  }
  return out;
}

}  // namespace stillmap
