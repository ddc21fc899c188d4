#include "evaluation/report_tables.hpp"

namespace stillmap {
namespace {

/// Calls visit(first cells of a row, histogram) for every pass with probabilities.
template <class Visitor>
void for_each_histogram(const std::vector<SequenceResult>& results, Visitor&& visit) {
  for (const SequenceResult& sequence : results)
    for (const MethodResult& method : sequence.methods) {
      for_each_pass(method, [&](const std::string& name, const PassScore& pass) {
        const std::vector<std::string> start = {sequence.name, method.method, name};
        if (!pass.probabilities().empty()) visit(start, pass.probabilities());
      });
    }
}

void add_row(TextTable& table, std::vector<std::string> row, const std::vector<std::string>& rest) {
  row.insert(row.end(), rest.begin(), rest.end());
  table.add_row(std::move(row));
}

}  // namespace

TextTable threshold_table(const std::vector<SequenceResult>& results) {
  TextTable table({"sequence", "method", "pass", "removed below p_static", "PR", "RR"});
  for_each_histogram(results, [&](const auto& start, const ProbabilityHistogram& histogram) {
    for (int threshold = 0; threshold <= 100; ++threshold)
      add_row(table, start,
              {cell(0.01 * threshold), cell(histogram.pr_at(threshold)), cell(histogram.rr_at(threshold))});
  });
  return table;
}

TextTable calibration_table(const std::vector<SequenceResult>& results) {
  TextTable table({"sequence", "method", "pass", "p_static from", "points", "mean p_static",
                   "truly static share", "expected calibration error"});
  for_each_histogram(results, [&](const auto& start, const ProbabilityHistogram& histogram) {
    const auto deciles = histogram.deciles();
    for (std::size_t i = 0; i < deciles.size(); ++i) {
      const bool any = deciles[i].points > 0;
      add_row(table, start,
              {cell(0.1 * static_cast<double>(i), 1), std::to_string(deciles[i].points),
               any ? cell(deciles[i].mean_p_static, 4) : "not defined",
               any ? cell(deciles[i].static_share, 4) : "not defined",
               cell(histogram.expected_calibration_error(), 4)});
    }
  });
  return table;
}

TextTable reason_table(const std::vector<SequenceResult>& results) {
  TextTable table({"sequence", "method", "pass", "reason", "p_static from", "static", "dynamic"});
  for (const SequenceResult& sequence : results)
    for (const MethodResult& method : sequence.methods)
      for_each_pass(method, [&](const std::string& name, const PassScore& pass) {
        for (const auto& [reason, histogram] : pass.reasons())
          for (std::size_t bin = 0; bin < ProbabilityHistogram::kBins; ++bin) {
            if (histogram.static_in(bin) + histogram.dynamic_in(bin) == 0) continue;
            table.add_row({sequence.name, method.method, name, to_string(reason),
                           cell(static_cast<double>(bin) / ProbabilityHistogram::kBins),
                           std::to_string(histogram.static_in(bin)),
                           std::to_string(histogram.dynamic_in(bin))});
          }
      });
  return table;
}

TextTable cost_table(const std::vector<SequenceResult>& results) {
  TextTable table({"sequence", "method", "CPU ms a scan, taken in", "CPU ms a scan, all", "peak memory MB"});
  for (const SequenceResult& sequence : results)
    for (const MethodResult& method : sequence.methods)
      table.add_row({sequence.name, method.method, cell(method.cost.at_once_cpu_ms),
                     cell(method.cost.total_cpu_ms), cell(method.cost.peak_mb, 1)});
  return table;
}

}  // namespace stillmap
