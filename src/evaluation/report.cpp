#include "evaluation/report.hpp"

#include <filesystem>

#include "evaluation/report_tables.hpp"
#include "io/atomic_file.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

/// Whether the preset `paper` beats the three baselines as they are set in section 2.1.
std::string comparison(const SequenceResult& result) {
  const auto score_of = [&](const std::string& name) -> Percent {
    for (const MethodResult& method : result.methods)
      if (method.method == name) return method.final.total().figures(Uncertain::kKept).score;
    return std::nullopt;
  };
  const Percent paper = score_of("paper");
  if (!paper) return "";
  std::string text = "By score, the preset `paper` (" + cell(paper) + ")";
  std::string separator = " ";
  for (const char* name : {"octomap", "erasor", "removert", "default"}) {
    const Percent other = score_of(name);
    if (!other) continue;
    text += separator + (*paper > *other ? "beats " : "does not beat ") + name + " (" + cell(other) + ")";
    separator = ", ";
  }
  return text + ".\n\n";
}

std::string tables_markdown(const std::vector<SequenceResult>& results) {
  std::string text =
      "# Results\n\nPR: static points kept. RR: dynamic points removed. score: their harmonic mean. "
      "Without a word, uncertain counts as kept (only dynamic is removed); \"dropped\": only static is "
      "kept. Counted per input point. Final: by the map after the last scan, truth labels/. At once: at the "
      "scan's own time, truth labels_now/ where there is one. Delayed: the same, judged again --delay scans "
      "later. Calibration error: expected |p_static - share that is static|, 0 to 1.\n\n";
  text += passes_table(results).markdown() + "\n" + details_table(results).markdown() + "\n";
  text += "PR / RR / score, final:\n\n" + overview_table(results).markdown() + "\n";
  for (const SequenceResult& result : results) {
    text += "## " + result.name + "\n\nThis run: " + result.run + ".\n\n";
    if (result.paper)
      text += "In the form of " + result.paper->table +
              "; the paper's figures are of another run: " + result.paper->data + ".\n\n";
    text += "Final:\n\n" + paper_form_table(result).markdown() + "\n" + comparison(result);
    const TextTable at_once = pass_table(result, &MethodResult::at_once);
    if (!at_once.empty()) text += "At once:\n\n" + at_once.markdown() + "\n";
    const TextTable delayed = pass_table(result, &MethodResult::delayed);
    if (!delayed.empty()) text += "Delayed:\n\n" + delayed.markdown() + "\n";
  }
  return text;
}

std::string conditions_markdown(const std::vector<SequenceResult>& results,
                                const ReportConditions& conditions) {
  TextTable table({"condition", "value"});
  for (const auto& [name, value] : conditions) table.add_row({name, value});
  return "# Conditions\n\n" + table.markdown() + "\n# Cost\n\n" + cost_table(results).markdown();
}

std::string picture_csv(const std::vector<PicturePoint>& picture) {
  TextTable table({"x_m", "y_m", "z_m", "code"});
  for (const PicturePoint& point : picture)
    table.add_row({cell(point.point.x(), 3), cell(point.point.y(), 3), cell(point.point.z(), 3),
                   std::to_string(static_cast<int>(point.code))});
  return table.csv();
}

}  // namespace

void write_report(const std::string& folder, const std::vector<SequenceResult>& results,
                  const ReportConditions& conditions) {
  const fs::path out(folder);
  fs::create_directories(out / "settings");
  fs::create_directories(out / "points");
  const auto write = [&](const fs::path& name, const std::string& text) {
    write_text_atomically((out / name).string(), text);
  };
  write("tables.md", tables_markdown(results));
  write("conditions.md", conditions_markdown(results, conditions));
  write("scores.csv", score_table(results).csv());
  write("classes.csv", class_table(results).csv());
  write("ranges.csv", range_table(results).csv());
  write("objects.csv", object_table(results).csv());
  write("scans.csv", scan_table(results).csv());
  write("thresholds.csv", threshold_table(results).csv());
  write("calibration.csv", calibration_table(results).csv());
  write("reasons.csv", reason_table(results).csv());
  write("costs.csv", cost_table(results).csv());
  for (const SequenceResult& result : results)
    for (const MethodResult& method : result.methods) {
      write(fs::path("settings") / (method.method + ".yaml"), method.settings);
      write(fs::path("points") / (result.name + "." + method.method + ".csv"), picture_csv(method.picture));
    }
}

}  // namespace stillmap
