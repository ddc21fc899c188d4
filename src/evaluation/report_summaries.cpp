#include "evaluation/report_tables.hpp"

namespace stillmap {

TextTable overview_table(const std::vector<SequenceResult>& results) {
  std::vector<std::string> header = {"sequence"};
  if (!results.empty())
    for (const MethodResult& method : results.front().methods) header.push_back(method.method);
  TextTable table(header);
  for (const SequenceResult& result : results) {
    std::vector<std::string> row = {result.name};
    for (const MethodResult& method : result.methods) {
      const Figures figures = method.final.total().figures(Uncertain::kKept);
      row.push_back(cell(figures.pr, 1) + " / " + cell(figures.rr, 1) + " / " + cell(figures.score, 1));
    }
    table.add_row(std::move(row));
  }
  return table;
}

TextTable paper_form_table(const SequenceResult& result) {
  TextTable table({"Sequence", "Method", "PR (%)", "RR (%)", "score", "PR dropped", "RR dropped",
                   "score dropped", "the paper's PR", "the paper's RR", "the paper's score"});
  for (const MethodResult& method : result.methods) {
    const Figures kept = method.final.total().figures(Uncertain::kKept);
    const Figures dropped = method.final.total().figures(Uncertain::kDropped);
    std::vector<std::string> row = {result.name,      method.method,      cell(kept.pr),
                                    cell(kept.rr),    cell(kept.score),   cell(dropped.pr),
                                    cell(dropped.rr), cell(dropped.score)};
    std::vector<std::string> theirs = {"-", "-", "-"};
    if (result.paper)
      for (const PaperExperiment::Row& row_of_paper : result.paper->rows)
        if (row_of_paper.method == method.method)
          theirs = {cell(row_of_paper.pr), cell(row_of_paper.rr), cell(row_of_paper.score)};
    row.insert(row.end(), theirs.begin(), theirs.end());
    table.add_row(std::move(row));
  }
  return table;
}

TextTable at_once_table(const SequenceResult& result) {
  TextTable table(
      {"Method", "PR (%)", "RR (%)", "score", "IoU", "score dropped", "vegetation kept", "delay (scans)"});
  for (const MethodResult& method : result.methods) {
    if (!method.at_once) continue;
    const Figures kept = method.at_once->total().figures(Uncertain::kKept);
    const Figures dropped = method.at_once->total().figures(Uncertain::kDropped);
    table.add_row({method.method, cell(kept.pr), cell(kept.rr), cell(kept.score), cell(kept.iou),
                   cell(dropped.score), cell(method.at_once->vegetation_kept(Uncertain::kKept)),
                   cell(method.at_once->delay().median_scans, 1)});
  }
  return table;
}

TextTable ablation_table(const std::vector<SequenceResult>& results) {
  TextTable table({"sequence", "method", "at once PR", "RR", "score", "IoU", "final PR", "RR", "score",
                   "score dropped", "CPU ms a scan"});
  for (const SequenceResult& sequence : results)
    for (const MethodResult& method : sequence.methods) {
      const Figures now = method.at_once ? method.at_once->total().figures(Uncertain::kKept) : Figures();
      const Figures final = method.final.total().figures(Uncertain::kKept);
      const Figures dropped = method.final.total().figures(Uncertain::kDropped);
      table.add_row({sequence.name, method.method, cell(now.pr), cell(now.rr), cell(now.score), cell(now.iou),
                     cell(final.pr), cell(final.rr), cell(final.score), cell(dropped.score),
                     cell(method.cost.at_once_cpu_ms)});
    }
  return table;
}

}  // namespace stillmap
