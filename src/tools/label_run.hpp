#pragma once

#include <cstddef>
#include <string>

#include "io/sequence.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {

/// What to label and where to put it.
struct LabelJob {
  std::string out;
  std::size_t from = 0;
  std::size_t scans = 0;  ///< 0 = to the end
  std::size_t stride = 1;
  std::size_t delay = 0;  ///< scans until the delayed labels; 0 = none
  bool final_labels = true;
};

/// Runs the engine over the sequence and writes out/online, out/delayed, out/final, out/static_map.pcd and
/// out/summary.json. Throws std::runtime_error on input or output that does not work.
void label_sequence(Sequence& sequence, const Parameters& parameters, const LabelJob& job);

}  // namespace stillmap
