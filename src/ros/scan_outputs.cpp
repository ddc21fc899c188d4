#include "ros/scan_outputs.hpp"

#include <nav_msgs/Odometry.h>

#include <boost/make_shared.hpp>

#include "messages/frame_id.hpp"
#include "messages/labelled_cloud.hpp"
#include "messages/pose_message.hpp"

namespace stillmap {
namespace {

constexpr int kQueue = 10;

template <class MakeCloud>
void publish_if_wanted(const ros::Publisher& publisher, const MakeCloud& make_cloud) {
  if (publisher.getNumSubscribers() == 0) return;
  const sensor_msgs::PointCloud2Ptr cloud = make_cloud();
  cloud->header.frame_id = without_leading_slash(cloud->header.frame_id);
  publisher.publish(cloud);
}

}  // namespace

ScanOutputs::ScanOutputs(ros::NodeHandle private_nh, int resolved_delay)
    : static_(private_nh.advertise<sensor_msgs::PointCloud2>("static_points", kQueue)),
      dynamic_(private_nh.advertise<sensor_msgs::PointCloud2>("dynamic_points", kQueue)),
      uncertain_(private_nh.advertise<sensor_msgs::PointCloud2>("uncertain_points", kQueue)),
      labelled_(private_nh.advertise<sensor_msgs::PointCloud2>("labelled_points", kQueue)),
      sensor_odometry_(private_nh.advertise<nav_msgs::Odometry>("sensor_odometry", kQueue)),
      status_(private_nh.advertise<Status>("status", kQueue)),
      delayed_(static_cast<std::size_t>(resolved_delay)) {
  if (resolved_delay > 0) resolved_ = private_nh.advertise<sensor_msgs::PointCloud2>("resolved", kQueue);
}

void ScanOutputs::publish(const PairedScan& paired, const ScanLabels& labels) {
  const sensor_msgs::PointCloud2& cloud = *paired.cloud;
  publish_if_wanted(static_, [&] { return select_rows(cloud, labels, Label::kStatic); });
  publish_if_wanted(dynamic_, [&] { return select_rows(cloud, labels, Label::kDynamic); });
  publish_if_wanted(uncertain_, [&] {
    return select_rows(cloud, labels, {Label::kUncertain, Label::kInvalid});
  });
  publish_if_wanted(labelled_, [&] { return add_label_fields(cloud, labels); });
}

void ScanOutputs::publish_resolved(const Mapper& mapper, const PairedScan& paired, const ScanLabels& labels) {
  if (resolved_.getNumSubscribers() == 0)  // of no topic, none
    delayed_.clear();
  else if (const auto settled = delayed_.add(mapper, paired, labels))
    publish_resolved(*settled);
}

void ScanOutputs::publish_waiting(const Mapper& mapper) {
  while (const auto settled = delayed_.settle_oldest(mapper)) publish_resolved(*settled);
}

void ScanOutputs::publish_resolved(const Delayed::Settled& settled) {
  publish_if_wanted(resolved_, [&] { return add_label_fields(*settled.scan.cloud, settled.labels); });
}

void ScanOutputs::publish(const Status& status) {
  if (status_.getNumSubscribers() > 0) status_.publish(boost::make_shared<Status>(status));
}

void ScanOutputs::publish(const std_msgs::Header& header, const Eigen::Isometry3d& T_map_sensor,
                          const std::string& map_frame) {
  if (sensor_odometry_.getNumSubscribers() == 0) return;
  const auto odometry = boost::make_shared<nav_msgs::Odometry>();
  odometry->header.stamp = header.stamp;
  odometry->header.frame_id = map_frame;
  odometry->pose.pose = to_message(T_map_sensor);
  sensor_odometry_.publish(odometry);
}

}  // namespace stillmap
