#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "doctor/finding.hpp"

namespace stillmap {

/// What came in, before any scan is looked at.
struct InputFacts {
  std::size_t clouds = 0;    ///< that came since the poses did
  std::size_t answered = 0;  ///< of them, that found their pose
  std::string why_not;       ///< what the last one without a pose lacked
  bool uses_tf = false;
  std::vector<std::string> tf_frames;  ///< that tf2 knows
  std::vector<std::string> needed_frames;
  bool clock_stands = false;  ///< use_sim_time without a /clock
};

/// Stamps that do not pair, frames that tf2 does not know, a clock that stands.
std::vector<Finding> check_input(const InputFacts& facts);

}  // namespace stillmap
