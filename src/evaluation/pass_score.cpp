#include "evaluation/pass_score.hpp"

#include <algorithm>
#include <stdexcept>

#include "evaluation/semantic_classes.hpp"

namespace stillmap {
namespace {

std::size_t range_band(const Eigen::Vector3f& point_sensor_m) {
  const float range_m = point_sensor_m.norm();
  return range_m < 10 ? 0 : range_m < 30 ? 1 : range_m < 50 ? 2 : 3;
}

void require_size(const Frame& frame, const char* what, std::size_t size) {
  if (size == frame.scan.points.size()) return;
  throw std::runtime_error("scan " + frame.name + ": " + std::to_string(size) + " " + what + " for " +
                           std::to_string(frame.scan.points.size()) + " points; expected one for each");
}

}  // namespace

void PassScore::add(const Frame& frame, const std::vector<std::uint32_t>& truth,
                    const PointVerdicts& verdicts) {
  require_size(frame, "labels", truth.size());
  require_size(frame, "verdicts", verdicts.label.size());
  Confusion& scan = scans_.emplace_back();
  for (std::size_t row = 0; row < truth.size(); ++row) {
    if (is_ignored(truth[row])) continue;
    const bool dynamic = is_moving(truth[row]);
    const Label verdict = verdicts.label[row];
    scan.add(dynamic, verdict);
    classes_[class_of(truth[row])].add(dynamic, verdict);
    ranges_[range_band(frame.scan.points[row])].add(dynamic, verdict);
    if (!verdicts.p_static.empty()) probabilities_.add(verdicts.p_static[row], dynamic);
    if (!verdicts.reason.empty()) reasons_[verdicts.reason[row]].add(verdicts.p_static[row], dynamic);
  }
  total_ += scan;
  add_objects(truth, verdicts.label);
}

void PassScore::add_objects(const std::vector<std::uint32_t>& truth, const std::vector<Label>& verdicts) {
  struct Seen {
    std::size_t points = 0, removed = 0;
  };
  std::map<std::uint32_t, Seen> seen;
  for (std::size_t row = 0; row < truth.size(); ++row) {
    if (!is_moving(truth[row]) || instance_of(truth[row]) == 0) continue;
    Seen& object = seen[truth[row]];
    ++object.points;
    object.removed += verdicts[row] == Label::kDynamic;
  }
  const std::size_t scan = scans_.size() - 1;
  for (const auto& [label, now] : seen) {
    const auto [entry, created] = objects_.try_emplace(label);
    ObjectScore& object = entry->second;
    if (created) object.first_scan = scan;
    object.points += now.points;
    object.removed += now.removed;
    if (!object.first_scan_found && 2 * now.removed >= now.points) object.first_scan_found = scan;
  }
}

Percent PassScore::vegetation_kept(Uncertain uncertain) const {
  const auto vegetation = classes_.find(kVegetation);
  return vegetation != classes_.end() ? vegetation->second.figures(uncertain).pr : std::nullopt;
}

DelaySummary PassScore::delay() const {
  DelaySummary summary;
  std::vector<std::size_t> delays;
  for (const auto& [label, object] : objects_) {
    if (object.first_scan == 0) continue;
    ++summary.objects;
    if (const auto delay = object.delay_scans())
      delays.push_back(*delay);
    else
      ++summary.never;
  }
  std::sort(delays.begin(), delays.end());
  const std::size_t low = (summary.objects + 1) / 2, high = summary.objects / 2 + 1;  // ranks, from 1
  if (summary.objects > 0 && high <= delays.size())
    summary.median_scans = 0.5 * static_cast<double>(delays[low - 1] + delays[high - 1]);
  return summary;
}

}  // namespace stillmap
