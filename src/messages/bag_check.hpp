#pragma once

#include <string>

namespace stillmap {

/// rosbag believes what a bag says of itself: sizes, offsets, the name of a plugin that decrypts it. This
/// looks whether it is so before rosbag opens it. Throws std::runtime_error naming the file and what is
/// wrong.
void check_bag(const std::string& file);

}  // namespace stillmap
