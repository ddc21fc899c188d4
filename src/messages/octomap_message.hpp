#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <string>
#include <vector>

namespace stillmap {

/// The wire type octomap_msgs/Octomap. That package is not in Debian; with these traits every subscriber to
/// the real type takes this one.
struct OctomapMessage {
  std_msgs::Header header;
  std::uint8_t binary = true;  ///< free and occupied leaves only
  std::string id;              ///< class of the tree, "OcTree"
  double resolution = 0;       ///< m
  std::vector<std::int8_t> data;
};

}  // namespace stillmap

namespace ros {
namespace message_traits {

template <>
struct IsMessage<stillmap::OctomapMessage> : TrueType {};
template <>
struct HasHeader<stillmap::OctomapMessage> : TrueType {};

template <>
struct MD5Sum<stillmap::OctomapMessage> {
  static const char* value() { return "9a45536b45c5e409cd49f04bb2d9999f"; }
  static const char* value(const stillmap::OctomapMessage&) { return value(); }
};

template <>
struct DataType<stillmap::OctomapMessage> {
  static const char* value() { return "octomap_msgs/Octomap"; }
  static const char* value(const stillmap::OctomapMessage&) { return value(); }
};

template <>
struct Definition<stillmap::OctomapMessage> {
  static const char* value() {
    return "Header header\nbool binary\nstring id\nfloat64 resolution\nint8[] data\n"
           "\n"
           "================================================================================\n"
           "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";
  }
  static const char* value(const stillmap::OctomapMessage&) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<stillmap::OctomapMessage> {
  template <class Stream, class Message>
  static void allInOne(Stream& stream, Message message) {
    stream.next(message.header);
    stream.next(message.binary);
    stream.next(message.id);
    stream.next(message.resolution);
    stream.next(message.data);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace serialization
}  // namespace ros
