#pragma once

#include "evaluation/report.hpp"
#include "evaluation/text_table.hpp"

namespace stillmap {

/// Every figure of every sequence, method, pass, and way to count "uncertain".
TextTable score_table(const std::vector<SequenceResult>& results);
TextTable class_table(const std::vector<SequenceResult>& results);
TextTable range_table(const std::vector<SequenceResult>& results);
TextTable object_table(const std::vector<SequenceResult>& results);
TextTable scan_table(const std::vector<SequenceResult>& results);
TextTable threshold_table(const std::vector<SequenceResult>& results);
TextTable calibration_table(const std::vector<SequenceResult>& results);
/// Points by reason and p_static: what scripts/fit_calibration.py reads.
TextTable reason_table(const std::vector<SequenceResult>& results);
TextTable cost_table(const std::vector<SequenceResult>& results);

/// PR / RR / score of the final verdicts, uncertain kept: a line for each sequence, a column for each method.
TextTable overview_table(const std::vector<SequenceResult>& results);
/// A line for each sequence and method: the scores of the three passes.
TextTable passes_table(const std::vector<SequenceResult>& results);
/// And what else matters: plants kept, people and far things removed, delay, calibration.
TextTable details_table(const std::vector<SequenceResult>& results);
/// Tables 2 and 3 in the paper's form, the paper's own figures beside ours.
TextTable paper_form_table(const SequenceResult& result);
/// A line for each method that has the pass: &MethodResult::at_once or &MethodResult::delayed.
TextTable pass_table(const SequenceResult& result, std::optional<PassScore> MethodResult::*pass);
/// A line for each method: what it gives, at once and in the end, and what it costs.
TextTable ablation_table(const std::vector<SequenceResult>& results);

}  // namespace stillmap
