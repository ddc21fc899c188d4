# Recorded bags, read and written without a roscore. Included by CMakeLists.txt beside this file.
find_package(BZip2 REQUIRED)
add_library(stillmap_bags
  bag_check.cpp
  bag_records.cpp
  bag_sequence.cpp
  bag_topics.cpp
  bag_writer.cpp
  lidars_in_bag.cpp
  mapped_file.cpp)
target_link_libraries(stillmap_bags PUBLIC
  stillmap_messages ${rosbag_storage_LIBRARIES} ${roscpp_serialization_LIBRARIES}
  PRIVATE BZip2::BZip2 ${roslz4_LIBRARIES})
