#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "doctor/finding.hpp"
#include "messages/pairing_options.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// Rays that do not start where sensor_on_body says. Seen from its true place, the returns of a turning
/// sensor lie on rings of sharp elevation; from another place they do not. Sensors without rings are not
/// judged.
std::optional<Finding> check_ray_origin(const Scan& scan, const PairingOptions& said);

}  // namespace stillmap
