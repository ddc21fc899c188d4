#pragma once

#include "stillmap/map_contents.hpp"

namespace stillmap {

/// Where L may go; see Parameters.
struct LogOddsBounds {
  float min, max;
};

/// Adds a map of the same frame to another: where both have a voxel, their log-odds and counts add up. What
/// only one of them has stays as it is there. Throws std::invalid_argument when the voxel sizes differ;
/// `into` then is as it was.
void merge(MapContents& into, const MapContents& other, LogOddsBounds bounds);

}  // namespace stillmap
