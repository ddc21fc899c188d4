#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "stillmap/explanation.hpp"

namespace stillmap {

/// The explanation in rviz: a ball in the label's colour at the place, the words above it, and a line for
/// each scan's evidence: from its origin to where it measured. Red saw through, green hit, grey was stopped.
visualization_msgs::MarkerArray to_markers(const Explanation& explanation, const std::string& frame_id);

}  // namespace stillmap
