// PointCloud2 with any fields, offsets, strides, byte order and sizes: into points, and out with labels.

#include "cloud_input.hpp"
#include "expect.hpp"
#include "messages/labelled_cloud.hpp"
#include "messages/point_cloud_conversion.hpp"

namespace stillmap::fuzz {
namespace {

ScanLabels labels_for(std::size_t rows) {
  ScanLabels labels;
  for (std::size_t i = 0; i < rows; ++i) {
    labels.label.push_back(static_cast<Label>(i % 4));
    labels.p_static.push_back(0.25F);
    labels.reason.push_back(Reason{});
  }
  return labels;
}

void convert(const sensor_msgs::PointCloud2& cloud) {
  Scan scan;
  to_scan(cloud, scan);
  const std::size_t rows = row_count(cloud);
  expect(scan.points.size() == rows, "each row is a point");
  const ScanLabels labels = labels_for(rows);
  expect(row_count(*add_label_fields(cloud, labels)) == rows, "a labelled cloud has the rows of its input");
  std::size_t selected = 0;
  for (const Label label : {Label::kUncertain, Label::kStatic, Label::kDynamic, Label::kInvalid})
    selected += row_count(*select_rows(cloud, labels, label));
  expect(selected == rows, "the parts are the whole");
}

}  // namespace
}  // namespace stillmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stillmap::fuzz;
  Input in(data, size);
  const sensor_msgs::PointCloud2 cloud = take_cloud(in);
  expect_named_refusal("", [&] { convert(cloud); });
  return 0;
}
