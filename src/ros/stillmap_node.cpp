#include <ros/ros.h>

#include <stdexcept>

#include "ros/stillmap_ros.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "stillmap");
  try {
    const stillmap::StillmapRos inside(ros::NodeHandle(), ros::NodeHandle("~"));
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM("not started: " << error.what());
    return 1;
  }
  return 0;
}
