#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "stillmap/moving_box.hpp"

namespace stillmap {

/// A box for each thing; it is gone after `lifetime_s` unless the next scan shows it again.
visualization_msgs::MarkerArray to_markers(const std::vector<MovingBox>& boxes,
                                           const std_msgs::Header& header, double lifetime_s);

}  // namespace stillmap
