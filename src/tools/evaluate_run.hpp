#pragma once

#include <string>
#include <vector>

#include "evaluation/labelled_sequence.hpp"
#include "stillmap/parameters.hpp"
#include "tools/sequence_options.hpp"

namespace stillmap {

/// What to evaluate and where to put the report.
struct EvaluateJob {
  std::vector<std::string> sequences;  ///< labelled folders, or folders of such
  std::string semantic_kitti;          ///< run as in table 2; empty = not run
  SequenceOptions treescope;           ///< run as in table 3; an empty path = not run
  PartOptions part;                    ///< of `sequences`; its seed is everyone's
  std::vector<std::string> methods;
  std::size_t delay = 10;  ///< scans until the delayed verdicts; 0 = none
  bool ablation = false;
  bool brief = false;  ///< see RunOptions
  bool figures = true;
  std::string out;
};

/// Throws std::runtime_error on input or output that does not work.
void evaluate(const EvaluateJob& job, const Parameters& parameters, const std::string& command_line);

}  // namespace stillmap
