#pragma once

#include <optional>

#include "doctor/finding.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// A cloud that was thinned to voxels, or holds features only: near the sensor, a whole scan has many points
/// in each few centimetres, a thinned one has not.
std::optional<Finding> check_density(const Scan& scan);

}  // namespace stillmap
