#pragma once

#include <string>
#include <vector>

#include "evaluation/labelled_sequence.hpp"

namespace stillmap {

/// One of the two experiments of the paper, with the figures that it prints.
struct PaperExperiment {
  struct Row {
    std::string method;  ///< this package's name of it
    double pr, rr, score;
  };
  std::string table;  ///< "Table 2, SemanticKITTI 00"
  PartOptions part;   ///< what section 2.1 says of the run
  std::string data;   ///< what the paper used
  std::vector<Row> rows;

  static PaperExperiment semantic_kitti();
  static PaperExperiment treescope();
};

}  // namespace stillmap
