#include "tools/run_summary.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>
#include <numeric>
#include <thread>

#include "io/atomic_file.hpp"
#include "tools/cpu_model.hpp"
#include "tools/version.hpp"

namespace stillmap {
namespace {

using Json = nlohmann::json;

double now_ms(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

Json distribution(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double count = static_cast<double>(values.size());
  const auto percentile = [&](double share) {  // nearest rank
    return values[static_cast<std::size_t>(std::max(1.0, std::ceil(share * count))) - 1];
  };
  return {{"mean", std::accumulate(values.begin(), values.end(), 0.0) / count},
          {"p50", percentile(0.5)},
          {"p95", percentile(0.95)},
          {"p99", percentile(0.99)},
          {"max", values.back()}};
}

Json to_json(const ScanTimes& times) {
  return {{"cpu_ms", distribution(times.cpu_ms)}, {"wall_ms", distribution(times.wall_ms)}};
}

Json stage_means(const EngineClock& clock) {
  Json means;
  for (int stage = 0; stage < kStageCount; ++stage)
    means[to_string(static_cast<Stage>(stage))] =
        clock.stage_cpu_ms()[stage] / static_cast<double>(clock.scans().cpu_ms.size());
  return means;
}

Json to_json(const LabelTotals& totals) {
  return {{"static", totals.counts.is_static},
          {"dynamic", totals.counts.dynamic},
          {"uncertain", totals.counts.uncertain},
          {"invalid", totals.counts.invalid}};
}

Json to_json(const Parameters& parameters) {
  Json json;
  visit_parameters(parameters,
                   [&](const ParameterInfo& info, const auto& value) { json[info.name] = value; });
  return json;
}

double peak_rss_mb() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace

EngineClock::Instant EngineClock::now() const {
  return {now_ms(CLOCK_PROCESS_CPUTIME_ID) - (others_cpu_ms_ ? others_cpu_ms_() : 0),
          now_ms(CLOCK_MONOTONIC)};
}

void EngineClock::add(ScanTimes& times, const Instant& from, const Instant& to) {
  times.cpu_ms.push_back(to.cpu_ms - from.cpu_ms);
  times.wall_ms.push_back(to.wall_ms - from.wall_ms);
}

void EngineClock::start_scan() {
  scan_began_ = stage_began_ = now();
}

void EngineClock::stage_ended(Stage stage) {
  const Instant ended = now();
  stage_cpu_ms_[static_cast<int>(stage)] += ended.cpu_ms - stage_began_.cpu_ms;
  if (stage == Stage::kUpkeep) {
    add(until_labels_, scan_began_, stage_began_);
    add(upkeep_, stage_began_, ended);
  }
  stage_began_ = ended;
}

void EngineClock::end_scan() {
  add(scans_, scan_began_, now());
}

void LabelTotals::add(const ScanLabels& labels) {
  const LabelCounts scan = count(labels);
  ++scans;
  points += labels.label.size();
  counts.is_static += scan.is_static;
  counts.dynamic += scan.dynamic;
  counts.uncertain += scan.uncertain;
  counts.invalid += scan.invalid;
}

void write_summary(const std::string& path, const RunSummary& summary, const EngineClock& clock,
                   const Parameters& parameters) {
  Json json = {{"scans", summary.online.scans},
               {"points", summary.online.points},
               {"voxels", summary.voxels},
               {"cpu_ms", distribution(clock.scans().cpu_ms)},
               {"wall_ms", distribution(clock.scans().wall_ms)},
               {"until_labels", to_json(clock.until_labels())},
               {"upkeep", to_json(clock.upkeep())},
               {"stage_cpu_ms", stage_means(clock)},
               {"peak_rss_mb", peak_rss_mb()},
               {"labels", {{"online", to_json(summary.online)}}},
               {"parameters", to_json(parameters)},
               {"machine", {{"cpu", cpu_model()}, {"cores", std::thread::hardware_concurrency()}}},
               {"version", kVersion},
               {"git_revision", kGitRevision}};
  if (summary.delayed.scans > 0) json["labels"]["delayed"] = to_json(summary.delayed);
  if (summary.final.scans > 0) json["labels"]["final"] = to_json(summary.final);
  write_text_atomically(path, json.dump(2) + "\n");
}

}  // namespace stillmap
