#pragma once

#include <cstddef>

#include "io/sequence.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {

/// How long to drive, and what may be seen at the end; 0 = not asked.
struct SoakJob {
  std::size_t scans = 1000;
  std::size_t rows = 20;       ///< of the table, at most: one has three laps at least
  double most_mb = 0;          ///< resident memory of the process at any time
  double most_mb_per_km = 0;   ///< growth of it over the second half of the way, to the last second map
  double most_cost_ratio = 0;  ///< CPU time of the last lap against a map that began one lap before
  double most_different_percent = 0;  ///< labels of a row's last lap against those by such a map
};

/// Drives the sequence in laps, and prints cost per scan and memory over the way, a row for each stretch.
/// Beside the last two laps of a stretch goes a second map, new each time. In the last of them, scan by scan,
/// the old map's cost against the new one's shows growth whatever else the machine does, and its labels
/// against the new one's show whether they drift. Throws std::runtime_error when more is seen than the job
/// allows.
void soak(Sequence& lap, const Parameters& parameters, const SoakJob& job);

}  // namespace stillmap
