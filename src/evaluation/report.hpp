#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/paper_results.hpp"
#include "evaluation/run_method.hpp"

namespace stillmap {

/// All methods on one sequence.
struct SequenceResult {
  std::string name;
  std::string run;  ///< "scans 0 to 9, at most 8000 points each, seed 7"
  std::optional<PaperExperiment> paper;
  std::vector<MethodResult> methods;
};

/// Under which conditions a report was made: pairs of name and value.
using ReportConditions = std::vector<std::pair<std::string, std::string>>;

/// Writes tables.md, the CSV files, settings/, points/ and conditions.md into the folder. All but
/// conditions.md and costs.csv are the same bytes whenever they are made from the same input. Throws
/// std::runtime_error naming the file that cannot be written.
void write_report(const std::string& folder, const std::vector<SequenceResult>& results,
                  const ReportConditions& conditions);

}  // namespace stillmap
