#pragma once

#include <cstddef>
#include <string>

#include "io/sequence.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {

/// Has the mapper process the first `scans` scans (0 = all) of a recording, with a progress bar.
void map_scans(Mapper& mapper, Sequence& sequence, std::size_t scans, const std::string& title);

}  // namespace stillmap
