#include "messages/labelled_cloud.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "messages/fields_of.hpp"
#include "messages/make_cloud.hpp"
#include "messages/point_cloud_conversion.hpp"

namespace stillmap {
namespace {

ScanLabels labels_of(const std::vector<Label>& label) {
  ScanLabels labels;
  labels.label = label;
  for (std::size_t i = 0; i < label.size(); ++i) {
    labels.p_static.push_back(0.1f * static_cast<float>(i));
    labels.reason.push_back(static_cast<Reason>(i));
  }
  return labels;
}

const std::vector<Label> kLabels = {Label::kStatic,  Label::kDynamic, Label::kInvalid, Label::kUncertain,
                                    Label::kDynamic, Label::kStatic,  Label::kDynamic};

sensor_msgs::PointCloud2Ptr cloud_of(std::size_t points) {
  std::vector<Eigen::Vector3d> list;
  for (std::size_t i = 0; i < points; ++i) list.emplace_back(i, 2.0 * i, -1.0);
  return make_cloud(list, 42);
}

std::string row(const sensor_msgs::PointCloud2& cloud, std::size_t i, std::size_t bytes) {
  return std::string(reinterpret_cast<const char*>(row_data(cloud, i)), bytes);
}

TEST(LabelledCloud, TheThreeCloudsPartitionTheInputByteByByte) {
  const auto cloud = cloud_of(kLabels.size());
  const ScanLabels labels = labels_of(kLabels);
  const auto is_static = select_rows(*cloud, labels, Label::kStatic);
  const auto dynamic = select_rows(*cloud, labels, Label::kDynamic);
  const auto uncertain = select_rows(*cloud, labels, {Label::kUncertain, Label::kInvalid});
  const std::vector<std::pair<sensor_msgs::PointCloud2ConstPtr, std::vector<std::size_t>>> expected = {
      {is_static, {0, 5}}, {dynamic, {1, 4, 6}}, {uncertain, {2, 3}}};
  for (const auto& [part, rows] : expected) {
    EXPECT_EQ(part->header.stamp, cloud->header.stamp);
    EXPECT_EQ(part->header.frame_id, cloud->header.frame_id);
    EXPECT_EQ(fields_of(*part), fields_of(*cloud));
    ASSERT_EQ(row_count(*part), rows.size());
    ASSERT_EQ(part->data.size(), rows.size() * cloud->point_step);
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_EQ(row(*part, i, cloud->point_step), row(*cloud, rows[i], cloud->point_step));
  }
}

TEST(LabelledCloud, MaskedRowsHaveNoPlaceAndKeepTheRest) {
  const auto cloud = cloud_of(kLabels.size());
  const auto out = mask_rows(*cloud, labels_of(kLabels), {Label::kDynamic, Label::kUncertain});
  EXPECT_FALSE(out->is_dense);
  EXPECT_EQ(fields_of(*out), fields_of(*cloud));
  Scan scan;
  to_scan(*out, scan);
  for (std::size_t i = 0; i < kLabels.size(); ++i) {
    const bool masked = kLabels[i] == Label::kDynamic || kLabels[i] == Label::kUncertain;
    EXPECT_EQ(scan.points[i].array().isNaN().all(), masked) << i;
    if (!masked) {
      EXPECT_EQ(row(*out, i, cloud->point_step), row(*cloud, i, cloud->point_step));
    }
    const std::size_t xyz = 3 * sizeof(float), rest = cloud->point_step - xyz;
    EXPECT_EQ(row(*out, i, cloud->point_step).substr(xyz, rest),
              row(*cloud, i, cloud->point_step).substr(xyz, rest));
  }
}

TEST(LabelledCloud, AddsTheThreeFieldsBehindTheInputs) {
  const auto cloud = cloud_of(kLabels.size());
  const auto out = add_label_fields(*cloud, labels_of(kLabels));
  ASSERT_EQ(row_count(*out), kLabels.size());
  ASSERT_EQ(out->fields.size(), 7u);
  EXPECT_EQ(out->fields[4].name, "p_static");
  EXPECT_EQ(out->fields[5].name, "label");
  EXPECT_EQ(out->fields[6].name, "reason");
  for (std::size_t i = 0; i < kLabels.size(); ++i) {
    EXPECT_EQ(row(*out, i, cloud->point_step), row(*cloud, i, cloud->point_step));
    float p_static;
    std::memcpy(&p_static, row_data(*out, i) + out->fields[4].offset, 4);
    EXPECT_EQ(p_static, 0.1f * static_cast<float>(i));
    EXPECT_EQ(row_data(*out, i)[out->fields[5].offset], static_cast<std::uint8_t>(kLabels[i]));
    EXPECT_EQ(row_data(*out, i)[out->fields[6].offset], i);
  }
}

TEST(LabelledCloud, KeepsTheInputsOwnLabelUnderAnotherName) {
  const auto cloud = cloud_of(2);
  cloud->fields[3].name = "label";
  const auto out = add_label_fields(*cloud, labels_of({Label::kStatic, Label::kStatic}));
  EXPECT_EQ(out->fields[3].name, "input_label");
  EXPECT_EQ(out->fields[5].name, "label");
}

TEST(LabelledCloud, KeepsImageLikeRowsAndTheirByteOrder) {
  const auto cloud = cloud_of(4);
  make_bigendian(*cloud);
  cloud->height = cloud->width = 2;
  cloud->row_step = 2 * cloud->point_step;
  const auto out = add_label_fields(*cloud, labels_of(std::vector<Label>(4, Label::kDynamic)));
  EXPECT_EQ(out->height, 2u);
  EXPECT_EQ(out->width, 2u);
  const std::uint8_t* p_static = row_data(*out, 1) + out->fields[4].offset;  // 0.1f is 0x3DCCCCCD
  EXPECT_EQ(p_static[0], 0x3D);
  EXPECT_EQ(p_static[3], 0xCD);
  Scan scan;
  to_scan(*out, scan);
  EXPECT_EQ(scan.points[3], Eigen::Vector3f(3, 6, -1));
}

TEST(LabelledCloud, AnEmptyCloudGivesEmptyClouds) {
  const auto cloud = cloud_of(0);
  EXPECT_EQ(row_count(*select_rows(*cloud, ScanLabels(), Label::kStatic)), 0u);
  EXPECT_TRUE(add_label_fields(*cloud, ScanLabels())->data.empty());
}

}  // namespace
}  // namespace stillmap
