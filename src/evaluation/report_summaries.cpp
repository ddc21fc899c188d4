#include "evaluation/report_tables.hpp"

#include "evaluation/semantic_classes.hpp"

namespace stillmap {
namespace {

const PassScore* pointer(const std::optional<PassScore>& pass) {
  return pass ? &*pass : nullptr;
}

std::string three(const PassScore* pass) {
  const Figures figures = pass ? pass->total().figures(Uncertain::kKept) : Figures();
  return cell(figures.pr) + " / " + cell(figures.rr) + " / " + cell(figures.score);
}

Percent dropped(const PassScore* pass) {
  return pass ? pass->total().figures(Uncertain::kDropped).score : std::nullopt;
}

std::string calibration(const PassScore* pass) {
  return cell(pass ? pass->probabilities().expected_calibration_error() : std::nullopt, 3);
}

Percent removed(const PassScore& pass, std::uint16_t semantic_class) {
  const auto part = pass.classes().find(semantic_class);
  return part != pass.classes().end() ? part->second.figures(Uncertain::kKept).rr : std::nullopt;
}

}  // namespace

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

TextTable passes_table(const std::vector<SequenceResult>& results) {
  TextTable table({"sequence", "method", "at once: PR / RR / score", "IoU", "dropped: score",
                   "delayed: PR / RR / score", "final: PR / RR / score", "dropped: score"});
  for (const SequenceResult& sequence : results)
    for (const MethodResult& method : sequence.methods) {
      const Figures now = method.at_once ? method.at_once->total().figures(Uncertain::kKept) : Figures();
      table.add_row({sequence.name, method.method, three(pointer(method.at_once)), cell(now.iou),
                     cell(dropped(pointer(method.at_once))), three(pointer(method.delayed)),
                     three(&method.final), cell(dropped(&method.final))});
    }
  return table;
}

TextTable details_table(const std::vector<SequenceResult>& results) {
  TextTable table({"sequence", "method", "vegetation kept: at once", "final", "people removed: final",
                   "30 to 50 m removed: final", "delay, scans", "calibration error: at once", "delayed",
                   "final"});
  constexpr std::size_t kFar = 2;  // of PassScore::kRangeBands
  for (const SequenceResult& sequence : results)
    for (const MethodResult& method : sequence.methods) {
      const PassScore& final = method.final;
      const PassScore* now = pointer(method.at_once);
      table.add_row({sequence.name, method.method,
                     cell(now ? now->vegetation_kept(Uncertain::kKept) : std::nullopt),
                     cell(final.vegetation_kept(Uncertain::kKept)), cell(removed(final, kMovingPerson)),
                     cell(final.ranges()[kFar].figures(Uncertain::kKept).rr),
                     cell(now ? now->delay().median_scans : std::nullopt, 1), calibration(now),
                     calibration(pointer(method.delayed)), calibration(&final)});
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

TextTable pass_table(const SequenceResult& result, std::optional<PassScore> MethodResult::*pass) {
  TextTable table({"Method", "PR (%)", "RR (%)", "score", "IoU", "score dropped", "vegetation kept",
                   "delay (scans)", "calibration error"});
  for (const MethodResult& method : result.methods) {
    const std::optional<PassScore>& score = method.*pass;
    if (!score) continue;
    const Figures kept = score->total().figures(Uncertain::kKept);
    const Figures dropped = score->total().figures(Uncertain::kDropped);
    table.add_row({method.method, cell(kept.pr), cell(kept.rr), cell(kept.score), cell(kept.iou),
                   cell(dropped.score), cell(score->vegetation_kept(Uncertain::kKept)),
                   cell(score->delay().median_scans, 1),
                   cell(score->probabilities().expected_calibration_error(), 3)});
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
