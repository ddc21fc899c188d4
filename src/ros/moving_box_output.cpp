#include "ros/moving_box_output.hpp"

#include "messages/box_markers.hpp"

namespace stillmap {

MovingBoxOutput::MovingBoxOutput(ros::NodeHandle private_nh, double lifetime_s)
    : lifetime_s_(lifetime_s),
      publisher_(private_nh.advertise<visualization_msgs::MarkerArray>("moving_boxes", 10)) {}

void MovingBoxOutput::publish(const Mapper& mapper, const PairedScan& paired,
                              const std::string& fixed_frame) {
  if (publisher_.getNumSubscribers() == 0) return;
  std_msgs::Header header;
  header.stamp = paired.cloud->header.stamp;
  header.frame_id = fixed_frame;
  publisher_.publish(to_markers(mapper.moving_boxes(paired.scan, paired.T_map_sensor), header, lifetime_s_));
}

}  // namespace stillmap
