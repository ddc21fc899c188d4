#include "messages/bag_writer.hpp"

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include <cstring>
#include <stdexcept>

#include "messages/pose_message.hpp"

namespace stillmap {
namespace {

constexpr std::uint32_t kIntensityOffset = 12, kRingOffset = 16, kLabelOffset = 20, kPointStep = 24;

ros::Time to_stamp(std::int64_t stamp_ns) {
  ros::Time stamp;
  stamp.fromNSec(std::uint64_t{BagWriter::kBagEpoch_s} * 1'000'000'000 +
                 static_cast<std::uint64_t>(stamp_ns));
  return stamp;
}

sensor_msgs::PointField field(const std::string& name, std::uint32_t offset, std::uint8_t type) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = type;
  field.count = 1;
  return field;
}

template <class T>
void copy_field(const std::vector<T>& values, std::uint32_t offset, std::uint8_t type,
                const std::string& name, sensor_msgs::PointCloud2& cloud) {
  if (values.empty()) return;
  if (values.size() != cloud.width)
    throw std::invalid_argument(name + ": " + std::to_string(values.size()) + " values for " +
                                std::to_string(cloud.width) + " points; give one for each or none");
  cloud.fields.push_back(field(name, offset, type));
  for (std::size_t i = 0; i < values.size(); ++i)
    std::memcpy(&cloud.data[i * kPointStep + offset], &values[i], sizeof(T));
}

/// Rows of zeros mean "no return" in every frame, so they stay zeros.
std::vector<Eigen::Vector3f> placed_points(const Frame& frame, bool in_world) {
  std::vector<Eigen::Vector3f> points = frame.scan.points;
  if (!in_world) return points;
  for (Eigen::Vector3f& point : points)
    if (!point.isZero(0)) point = (frame.T_map_sensor * point.cast<double>()).cast<float>();
  return points;
}

sensor_msgs::PointCloud2 to_cloud(const Frame& frame, const PointFields& fields, const BagTopics& topics) {
  using sensor_msgs::PointField;
  const std::vector<Eigen::Vector3f> points = placed_points(frame, topics.world_clouds);
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = to_stamp(frame.scan.stamp_ns);
  cloud.header.frame_id = topics.world_clouds ? topics.world_frame_id : topics.sensor_frame_id;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.point_step = kPointStep;
  cloud.row_step = cloud.width * kPointStep;
  cloud.data.resize(std::size_t{cloud.width} * kPointStep);
  cloud.fields = {field("x", 0, PointField::FLOAT32), field("y", 4, PointField::FLOAT32),
                  field("z", 8, PointField::FLOAT32)};
  for (std::size_t i = 0; i < points.size(); ++i)
    std::memcpy(&cloud.data[i * kPointStep], points[i].data(), 3 * sizeof(float));
  copy_field(fields.intensity, kIntensityOffset, PointField::FLOAT32, "intensity", cloud);
  copy_field(fields.ring, kRingOffset, PointField::UINT16, "ring", cloud);
  copy_field(fields.label, kLabelOffset, PointField::UINT32, "label", cloud);
  return cloud;
}

nav_msgs::Odometry to_odometry(const Frame& frame, const BagTopics& topics) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = to_stamp(frame.scan.stamp_ns);
  odometry.header.frame_id = topics.world_frame_id;
  odometry.child_frame_id = topics.sensor_frame_id;
  odometry.pose.pose = to_message(frame.T_map_sensor);
  return odometry;
}

tf2_msgs::TFMessage to_transform(const nav_msgs::Odometry& odometry) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  geometry_msgs::TransformStamped& transform = message.transforms.front();
  transform.header = odometry.header;
  transform.child_frame_id = odometry.child_frame_id;
  transform.transform.translation.x = odometry.pose.pose.position.x;
  transform.transform.translation.y = odometry.pose.pose.position.y;
  transform.transform.translation.z = odometry.pose.pose.position.z;
  transform.transform.rotation = odometry.pose.pose.orientation;
  return message;
}

}  // namespace

BagWriter::BagWriter(const std::string& file, const BagTopics& topics) : topics_(topics) {
  try {
    bag_.open(file, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(file + ": cannot be created: " + error.what());
  }
}

void BagWriter::write(const Frame& frame, const PointFields& fields) {
  const sensor_msgs::PointCloud2 cloud = to_cloud(frame, fields, topics_);
  const nav_msgs::Odometry odometry = to_odometry(frame, topics_);
  const ros::Time stamp = cloud.header.stamp;
  bag_.write(topics_.odometry, stamp, odometry);
  bag_.write(topics_.tf, stamp, to_transform(odometry));
  bag_.write(topics_.cloud, stamp, cloud);
}

}  // namespace stillmap
