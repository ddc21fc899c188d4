#pragma once

#include <cstddef>

#include "io/sequence.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {

/// How long to drive, and what may be seen at the end; 0 = not asked.
struct SoakJob {
  std::size_t scans = 1000;
  double most_mb = 0;                 ///< resident memory of the process at any time
  double most_mb_per_km = 0;          ///< growth of it over the second half of the way
  double most_cost_ratio = 0;         ///< CPU time of the last lap against a map that began one lap before it
  double most_different_percent = 0;  ///< labels of the last lap against those by that map
};

/// Drives the sequence in laps, and prints cost per scan and memory over the way. A second map, which begins
/// two laps before the end, processes the last lap too: scan by scan, the old map's cost against its own
/// shows growth whatever else the machine does, and its labels against that map's show whether they drift.
/// Throws std::runtime_error when more is seen than the job allows.
void soak(Sequence& lap, const Parameters& parameters, const SoakJob& job);

}  // namespace stillmap
