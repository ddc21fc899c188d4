#pragma once

#include <ros/serialization.h>
#include <rosbag/message_instance.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace stillmap {

/// Reads messages from bytes that nobody vouches for. ros::serialization::IStream makes room for as many
/// elements as an array says it has before it sees that they are not there: 16 bytes may ask for 200 GB.
class BoundedStream : public ros::serialization::Stream {
 public:
  static constexpr auto stream_type = ros::serialization::stream_types::Input;
  BoundedStream(std::uint8_t* data, std::uint32_t bytes) : Stream(data, bytes) {}

  template <class T>
  void next(T& value) {
    ros::serialization::deserialize(*this, value);
  }
  template <class T, class Allocator>
  void next(std::vector<T, Allocator>& values) {
    BoundedStream ahead(getData(), getLength());
    std::uint32_t count = 0;
    ahead.next(count);
    if (count > ahead.getLength())  // an element takes a byte at least
      throw std::runtime_error("an array says that it has " + std::to_string(count) + " elements and " +
                               std::to_string(ahead.getLength()) + " bytes follow");
    ros::serialization::deserialize(*this, values);
  }
  template <class T>
  BoundedStream& operator>>(T& value) {
    next(value);
    return *this;
  }
};

/// Throws std::runtime_error when the bytes end before the message or an array in it does not fit.
template <class Message>
void deserialize_bounded(std::vector<std::uint8_t>& bytes, Message& message) {
  if (bytes.empty()) throw std::runtime_error("the message is empty");
  BoundedStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  try {
    stream.next(message);
  } catch (const ros::serialization::StreamOverrunException&) {
    throw std::runtime_error("the message ends before its last field");
  }
}

/// A message of a bag. Throws std::runtime_error naming the topic when it is of another definition or
/// damaged.
template <class Message>
boost::shared_ptr<Message> read_message(const rosbag::MessageInstance& in_bag) {
  const auto refuse = [&](const std::string& what) -> std::runtime_error {
    return std::runtime_error(in_bag.getTopic() + ": " + what + "; the recording is damaged");
  };
  if (in_bag.getMD5Sum() != ros::message_traits::md5sum<Message>())
    throw refuse("a " + in_bag.getDataType() + " of another definition than this machine's " +
                 ros::message_traits::datatype<Message>());
  std::vector<std::uint8_t> bytes(in_bag.size());
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  in_bag.write(out);
  auto message = boost::make_shared<Message>();
  try {
    deserialize_bounded(bytes, *message);
  } catch (const std::runtime_error& error) {
    throw refuse(error.what());
  }
  return message;
}

}  // namespace stillmap
