#pragma once

#include <optional>

#include "doctor/finding.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// Rows without a return that were moved like points: many rows at one place. And scans that are nearly
/// empty.
std::optional<Finding> check_rows(const Scan& scan);

}  // namespace stillmap
