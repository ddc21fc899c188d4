# Recorded bags, read and written without a roscore. Included by CMakeLists.txt beside this file.
add_library(stillmap_bags
  bag_sequence.cpp
  bag_topics.cpp
  bag_writer.cpp)
target_link_libraries(stillmap_bags PUBLIC
  stillmap_messages ${rosbag_storage_LIBRARIES} ${roscpp_serialization_LIBRARIES})
