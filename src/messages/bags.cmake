# Recorded bags, read and written without a roscore. Included by CMakeLists.txt beside this file.
find_package(BZip2 REQUIRED)
add_library(stillmap_bags
  bag_check.cpp
  bag_records.cpp
  bag_sequence.cpp
  bag_topics.cpp
  mapped_file.cpp
  bag_writer.cpp)
target_link_libraries(stillmap_bags PUBLIC
  stillmap_messages ${rosbag_storage_LIBRARIES} ${roscpp_serialization_LIBRARIES}
  PRIVATE BZip2::BZip2 ${roslz4_LIBRARIES})
