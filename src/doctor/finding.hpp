#pragma once

#include <map>
#include <string>

namespace stillmap {

/// Something that would ruin the results, in one line: what was seen, and which parameter mends it.
struct Finding {
  std::string check;  ///< stamps, frames, axes, still, density, rows, origin, outcome, tf, clock
  std::string text;
  std::map<std::string, std::string> mend = {};  ///< parameters that mend it, where they are known
};

}  // namespace stillmap
