#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <initializer_list>

#include "stillmap/types.hpp"

namespace stillmap {

/// Some of the four labels.
class LabelSet {
 public:
  LabelSet(std::initializer_list<Label> labels) {
    for (const Label label : labels) bits_ |= bit(label);
  }
  LabelSet(Label label) : LabelSet({label}) {}
  bool contains(Label label) const { return (bits_ & bit(label)) != 0; }

 private:
  static unsigned bit(Label label) { return 1U << static_cast<unsigned>(label); }
  unsigned bits_ = 0;
};

/// The rows of the cloud that have one of the labels: same header, fields and order, copied byte by byte.
sensor_msgs::PointCloud2Ptr select_rows(const sensor_msgs::PointCloud2& cloud, const ScanLabels& labels,
                                        LabelSet wanted);

/// The whole cloud, where rows with one of the labels have NaN as x, y and z: an image-like cloud keeps its
/// form. The cloud must have been read by to_scan(), which checks its layout.
sensor_msgs::PointCloud2Ptr mask_rows(const sensor_msgs::PointCloud2& cloud, const ScanLabels& labels,
                                      LabelSet unwanted);

/// The whole cloud with p_static (float32), label and reason (uint8, see Label and Reason) added to each row.
/// A field of the input that has one of these names is kept as input_label and so on.
sensor_msgs::PointCloud2Ptr add_label_fields(const sensor_msgs::PointCloud2& cloud, const ScanLabels& labels);

}  // namespace stillmap
