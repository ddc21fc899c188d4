# catkin: messages, and what other packages are told. Included by the top CMakeLists.txt when STILLMAP_WITH_ROS is on.

# TBB has a CMake configuration of its own, and the build makes the folder of the version header.
#catkin_lint: ignore missing_cmake_modules missing_directory

# catkin snapshots PYTHONPATH for the tests from folders that must exist before it is found.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/devel/lib/python3/dist-packages)

find_package(catkin REQUIRED COMPONENTS
  diagnostic_msgs diagnostic_updater dynamic_reconfigure geometry_msgs message_generation nav_msgs nodelet pluginlib rosbag_storage
  roscpp roscpp_serialization roslz4 sensor_msgs std_msgs std_srvs tf2 tf2_ros visualization_msgs xmlrpcpp)

add_message_files(FILES LabelledMap.msg Status.msg)
add_service_files(DIRECTORY srv FILES ClearBox.srv DiffMap.srv ExplainPoint.srv LoadMap.srv RelabelBox.srv SaveMap.srv)
generate_messages(DEPENDENCIES geometry_msgs std_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES stillmap_core
  CATKIN_DEPENDS diagnostic_msgs diagnostic_updater dynamic_reconfigure geometry_msgs message_runtime nav_msgs nodelet pluginlib
    rosbag_storage roscpp roscpp_serialization roslz4 sensor_msgs std_msgs std_srvs tf2 tf2_ros visualization_msgs xmlrpcpp
  DEPENDS EIGEN3
  CFG_EXTRAS stillmap-extras.cmake)
