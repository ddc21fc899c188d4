#pragma once

#include <algorithm>
#include <string>

namespace stillmap {

/// tf1-era packages write "/camera_init"; tf2 knows it as "camera_init".
inline std::string without_leading_slash(const std::string& frame_id) {
  return frame_id.substr(std::min(frame_id.find_first_not_of('/'), frame_id.size()));
}

}  // namespace stillmap
