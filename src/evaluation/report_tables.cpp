#include "evaluation/report_tables.hpp"

#include "evaluation/semantic_classes.hpp"

namespace stillmap {
namespace {

constexpr Uncertain kBoth[] = {Uncertain::kKept, Uncertain::kDropped};

const char* name_of(Uncertain uncertain) {
  return uncertain == Uncertain::kKept ? "kept" : "dropped";
}

std::string number(std::size_t value) {
  return std::to_string(value);
}

/// Calls visit(sequence, method, name of the pass, pass) for every pass there is.
template <class Visitor>
void for_each_pass(const std::vector<SequenceResult>& results, Visitor&& visit) {
  for (const SequenceResult& sequence : results)
    for (const MethodResult& method : sequence.methods)
      for_each_pass(method, [&](const std::string& name, const PassScore& pass) {
        visit(sequence, method, name, pass);
      });
}

void add_parts(TextTable& table, const std::vector<std::string>& start, const Confusion& part) {
  const Figures kept = part.figures(Uncertain::kKept), dropped = part.figures(Uncertain::kDropped);
  std::vector<std::string> row = start;
  for (const std::string& value : {number(part.static_points()), number(part.dynamic_points()), cell(kept.pr),
                                   cell(kept.rr), cell(dropped.pr), cell(dropped.rr)})
    row.push_back(value);
  table.add_row(row);
}

const std::vector<std::string> kPartColumns = {"static points", "moving points", "PR kept",
                                               "RR kept",       "PR dropped",    "RR dropped"};

TextTable part_table(const std::string& part) {
  std::vector<std::string> header = {"sequence", "method", "pass", part};
  header.insert(header.end(), kPartColumns.begin(), kPartColumns.end());
  return TextTable(header);
}

}  // namespace

TextTable score_table(const std::vector<SequenceResult>& results) {
  TextTable table({"sequence", "run", "method", "pass", "uncertain", "PR (SA)", "RR (DA, recall)",
                   "score (HA)", "AA", "precision", "IoU", "vegetation kept", "delay scans",
                   "objects never found", "map-wise PR", "map-wise RR", "map-wise score"});
  for_each_pass(results, [&](const SequenceResult& sequence, const MethodResult& method,
                             const std::string& pass_name, const PassScore& pass) {
    for (const Uncertain uncertain : kBoth) {
      const Figures figures = pass.total().figures(uncertain);
      const bool at_once = pass_name == "at once", final = pass_name == "final";
      const Confusion& map = uncertain == Uncertain::kKept ? method.map_wise_kept : method.map_wise_dropped;
      const Figures map_wise = final ? map.figures(uncertain) : Figures();
      const DelaySummary delay = pass.delay();
      const auto only = [](bool applies, const std::string& text) { return applies ? text : "-"; };
      table.add_row({sequence.name, sequence.run, method.method, pass_name, name_of(uncertain),
                     cell(figures.pr), cell(figures.rr), cell(figures.score), cell(figures.aa),
                     cell(figures.precision), cell(figures.iou), cell(pass.vegetation_kept(uncertain)),
                     only(at_once, cell(delay.median_scans, 1)),
                     only(at_once, number(delay.never) + " of " + number(delay.objects)),
                     only(final, cell(map_wise.pr)), only(final, cell(map_wise.rr)),
                     only(final, cell(map_wise.score))});
    }
  });
  return table;
}

TextTable class_table(const std::vector<SequenceResult>& results) {
  TextTable table = part_table("class");
  for_each_pass(results, [&](const SequenceResult& sequence, const MethodResult& method,
                             const std::string& pass_name, const PassScore& pass) {
    for (const auto& [semantic_class, part] : pass.classes())
      add_parts(table, {sequence.name, method.method, pass_name, class_name(semantic_class)}, part);
  });
  return table;
}

TextTable range_table(const std::vector<SequenceResult>& results) {
  TextTable table = part_table("range");
  for_each_pass(results, [&](const SequenceResult& sequence, const MethodResult& method,
                             const std::string& pass_name, const PassScore& pass) {
    for (std::size_t band = 0; band < pass.ranges().size(); ++band)
      add_parts(table, {sequence.name, method.method, pass_name, PassScore::kRangeBands[band]},
                pass.ranges()[band]);
  });
  return table;
}

TextTable object_table(const std::vector<SequenceResult>& results) {
  TextTable table(
      {"sequence", "method", "pass", "class", "instance", "points", "RR kept", "first scan", "delay scans"});
  for_each_pass(results, [&](const SequenceResult& sequence, const MethodResult& method,
                             const std::string& pass_name, const PassScore& pass) {
    for (const auto& [label, object] : pass.objects()) {
      const auto delay = object.delay_scans();
      table.add_row({sequence.name, method.method, pass_name, class_name(class_of(label)),
                     number(instance_of(label)), number(object.points),
                     cell(percent(object.removed, object.points)), number(object.first_scan),
                     pass_name != "at once" ? "-"
                     : delay                ? number(*delay)
                                            : "never"});
    }
  });
  return table;
}

TextTable scan_table(const std::vector<SequenceResult>& results) {
  TextTable table({"sequence", "method", "pass", "uncertain", "scan", "PR", "RR", "precision", "IoU"});
  for_each_pass(results, [&](const SequenceResult& sequence, const MethodResult& method,
                             const std::string& pass_name, const PassScore& pass) {
    for (std::size_t k = 0; k < pass.scans().size(); ++k)
      for (const Uncertain uncertain : kBoth) {
        const Figures figures = pass.scans()[k].figures(uncertain);
        table.add_row({sequence.name, method.method, pass_name, name_of(uncertain), number(k),
                       cell(figures.pr), cell(figures.rr), cell(figures.precision), cell(figures.iou)});
      }
  });
  return table;
}

}  // namespace stillmap
