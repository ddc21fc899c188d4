#include "tools/evaluate_run.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>
#include <stdexcept>
#include <thread>

#include "evaluation/ablation.hpp"
#include "evaluation/injected_sequence.hpp"
#include "evaluation/report.hpp"
#include "evaluation/report_tables.hpp"
#include "tools/cpu_model.hpp"
#include "tools/plot_report.hpp"
#include "tools/progress_bar.hpp"
#include "tools/version.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

/// A sequence with what the report says of it.
struct Entry {
  std::string name, run;
  std::unique_ptr<LabelledSequence> sequence;
  std::optional<PaperExperiment> paper;
};

std::string name_of(const std::string& path) {
  const fs::path normal = fs::path(path).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).stem().string();
}

std::string describe(const PartOptions& part, std::size_t scans) {
  std::string text = std::to_string(scans) + " scans from number " + std::to_string(part.first);
  if (part.stride > 1) text += ", every " + std::to_string(part.stride) + "th";
  text +=
      part.max_points > 0 ? ", at most " + std::to_string(part.max_points) + " points each" : ", all points";
  return text + ", seed " + std::to_string(part.seed);
}

Entry open_folder(const std::string& path, const PartOptions& part) {
  Entry entry;
  entry.name = name_of(path);
  entry.sequence = std::make_unique<SequencePart>(std::make_unique<LabelledFolder>(path), part);
  entry.run = describe(part, entry.sequence->size());
  return entry;
}

/// A folder of `stillmap inject` is taken as it is; a bag gets its targets here.
Entry open_treescope(const SequenceOptions& treescope, PaperExperiment experiment, std::uint64_t seed) {
  if (fs::is_directory(treescope.path)) return open_folder(treescope.path, PartOptions());
  experiment.part.seed = seed;
  PartOptions scans = experiment.part;
  scans.max_points = 0;  // the targets come before the choice of points
  InjectionOptions injection;
  injection.max_points = experiment.part.max_points;
  injection.seed = seed;
  auto recorded = std::make_unique<StandingSequence>(treescope.open());
  Entry entry;
  entry.name = name_of(treescope.path);
  entry.sequence = std::make_unique<InjectedSequence>(
      std::make_unique<SequencePart>(std::move(recorded), scans), injection);
  entry.run = describe(experiment.part, entry.sequence->size()) + ", with targets put in";
  return entry;
}

/// A sequence itself, or all sequences in a folder of them.
std::vector<std::string> expand(const std::string& path) {
  if (!fs::is_directory(path) || fs::exists(fs::path(path) / "velodyne")) return {path};
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(path))
    if (fs::exists(entry.path() / "velodyne")) found.push_back(entry.path().string());
  std::sort(found.begin(), found.end());
  if (found.empty()) return {path};
  return found;
}

std::vector<Entry> open_all(const EvaluateJob& job) {
  std::vector<Entry> entries;
  if (!job.semantic_kitti.empty()) {
    PaperExperiment experiment = PaperExperiment::semantic_kitti();
    experiment.part.seed = job.part.seed;
    entries.push_back(open_folder(job.semantic_kitti, experiment.part));
    entries.back().paper = experiment;
  }
  if (!job.treescope.path.empty()) {
    const PaperExperiment experiment = PaperExperiment::treescope();
    entries.push_back(open_treescope(job.treescope, experiment, job.part.seed));
    entries.back().paper = experiment;
  }
  for (const std::string& path : job.sequences)
    for (const std::string& folder : expand(path)) entries.push_back(open_folder(folder, job.part));
  if (entries.empty())
    throw std::runtime_error("nothing to evaluate; give SEQUENCES, --semantickitti or --treescope");
  std::set<std::string> names;
  for (const Entry& entry : entries)
    if (!names.insert(entry.name).second)
      throw std::runtime_error("two sequences are called " + entry.name +
                               ", so their figures could not be told apart; link one under another name");
  return entries;
}

std::vector<MethodChoice> choose(const EvaluateJob& job, const Parameters& parameters) {
  if (job.ablation) return ablation_choices(parameters);
  std::vector<MethodChoice> choices;
  for (const std::string& name : job.methods) choices.push_back(choose_method(name, parameters));
  return choices;
}

ReportConditions conditions(const EvaluateJob& job, const std::string& command_line) {
  return {{"command", command_line},
          {"version", std::string(kVersion) + " (" + kGitRevision + ")"},
          {"machine", cpu_model() + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores"},
          {"seed", std::to_string(job.part.seed)},
          {"delay", std::to_string(job.delay) + " scans"},
          {"parameters", "settings/*.yaml"}};
}

}  // namespace

void evaluate(const EvaluateJob& job, const Parameters& parameters, const std::string& command_line) {
  const std::vector<MethodChoice> choices = choose(job, parameters);
  const std::vector<Entry> entries = open_all(job);
  RunOptions options;
  options.seed = job.part.seed;
  options.delay = job.delay;
  options.brief = job.brief;
  std::vector<SequenceResult> results;
  for (const Entry& entry : entries) {
    SequenceResult& result = results.emplace_back();
    result.name = entry.name;
    result.run = entry.run;
    result.paper = entry.paper;
    for (const MethodChoice& choice : choices) {
      ProgressBar progress(entry.name + ", " + choice.name, 2 * entry.sequence->size());
      result.methods.push_back(
          run_method(*entry.sequence, choice, options, [&progress] { progress.advance(); }));
    }
  }
  write_report(job.out, results, conditions(job, command_line));
  if (job.ablation)
    std::cout << ablation_table(results).markdown();
  else
    std::cout << passes_table(results).markdown() << "\n" << details_table(results).markdown();
  if (job.figures) plot_report(job.out);
}

}  // namespace stillmap
