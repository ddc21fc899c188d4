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

Json stage_means(const EngineClock& clock) {
  Json means;
  for (int stage = 0; stage < kStageCount; ++stage)
    means[to_string(static_cast<Stage>(stage))] =
        clock.stage_cpu_ms()[stage] / static_cast<double>(clock.cpu_ms().size());
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

double EngineClock::cpu_now_ms() const {
  return now_ms(CLOCK_PROCESS_CPUTIME_ID) - (others_cpu_ms_ ? others_cpu_ms_() : 0);
}

void EngineClock::start_scan() {
  scan_wall_ms_ = now_ms(CLOCK_MONOTONIC);
  scan_cpu_ms_ = stage_began_ms_ = cpu_now_ms();
}

void EngineClock::stage_ended(Stage stage) {
  const double now = cpu_now_ms();
  stage_cpu_ms_[static_cast<int>(stage)] += now - stage_began_ms_;
  stage_began_ms_ = now;
}

void EngineClock::end_scan() {
  cpu_ms_.push_back(cpu_now_ms() - scan_cpu_ms_);
  wall_ms_.push_back(now_ms(CLOCK_MONOTONIC) - scan_wall_ms_);
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
               {"cpu_ms", distribution(clock.cpu_ms())},
               {"wall_ms", distribution(clock.wall_ms())},
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
