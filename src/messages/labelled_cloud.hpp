#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "stillmap/types.hpp"

namespace stillmap {

/// The rows of the cloud that have one of the labels: same header, fields and order, copied byte by byte.
/// `second` takes the rows without a usable return along, so that three such clouds partition the input.
sensor_msgs::PointCloud2Ptr select_rows(const sensor_msgs::PointCloud2& cloud, const ScanLabels& labels,
                                        Label first, Label second);
inline sensor_msgs::PointCloud2Ptr select_rows(const sensor_msgs::PointCloud2& cloud,
                                               const ScanLabels& labels, Label label) {
  return select_rows(cloud, labels, label, label);
}

/// The whole cloud with p_static (float32), label and reason (uint8, see Label and Reason) added to each row.
/// A field of the input that has one of these names is kept as input_label and so on.
sensor_msgs::PointCloud2Ptr add_label_fields(const sensor_msgs::PointCloud2& cloud, const ScanLabels& labels);

}  // namespace stillmap
