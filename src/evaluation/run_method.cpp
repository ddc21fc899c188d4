#include "evaluation/run_method.hpp"

#include <random>

#include "evaluation/map_wise.hpp"
#include "evaluation/process_cost.hpp"
#include "evaluation/semantic_classes.hpp"

namespace stillmap {
namespace {

bool is_removed(Label verdict, Uncertain uncertain) {
  return verdict == Label::kDynamic || (uncertain == Uncertain::kDropped && verdict != Label::kStatic);
}

/// Calls visit(point in the map, truth, verdict) for every row that holds a return.
template <class Visitor>
void for_each_return(LabelledSequence& sequence, const std::vector<std::vector<Label>>& verdicts,
                     Visitor&& visit) {
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    const LabelledFrame scan = sequence.read(k);
    for (std::size_t row = 0; row < scan.labels.size(); ++row) {
      if (!is_return(scan.frame.scan.points[row])) continue;
      visit(scan.frame.T_map_sensor * scan.frame.scan.points[row].cast<double>(), scan.labels[row],
            verdicts[k][row]);
    }
  }
}

Confusion count_map_wise(LabelledSequence& sequence, const std::vector<std::vector<Label>>& verdicts,
                         double voxel_size_m, Uncertain uncertain) {
  MapWiseCount count(voxel_size_m);
  for_each_return(sequence, verdicts, [&](const Eigen::Vector3d& point, std::uint32_t truth, Label verdict) {
    if (!is_ignored(truth) && is_removed(verdict, uncertain)) count.add_removed(point, is_moving(truth));
  });
  for_each_return(sequence, verdicts, [&](const Eigen::Vector3d& point, std::uint32_t truth, Label verdict) {
    if (is_removed(verdict, uncertain)) return;
    count.add_to_map(point);
    if (!is_ignored(truth)) count.count_kept(is_moving(truth));
  });
  return count.counts();
}

/// A random choice, the same for every method.
std::vector<PicturePoint> take_picture(LabelledSequence& sequence,
                                       const std::vector<std::vector<Label>>& verdicts,
                                       const RunOptions& options) {
  std::size_t left = 0;
  const auto count = [&](const Eigen::Vector3d&, std::uint32_t truth, Label) { left += !is_ignored(truth); };
  for_each_return(sequence, verdicts, count);
  std::size_t wanted = std::min(left, options.picture_points);
  std::mt19937_64 random(options.seed);
  std::vector<PicturePoint> picture;
  const Eigen::Vector3d origin = sequence.read(0).frame.T_map_sensor.translation();
  for_each_return(sequence, verdicts, [&](const Eigen::Vector3d& point, std::uint32_t truth, Label verdict) {
    if (is_ignored(truth) || random() % left-- >= wanted) return;
    --wanted;
    const bool removed = is_removed(verdict, Uncertain::kKept);
    const PictureCode code = is_moving(truth) ? (removed ? PictureCode::kRemovedRight : PictureCode::kMissed)
                                              : (removed ? PictureCode::kRemovedWrong : PictureCode::kKept);
    picture.push_back({(point - origin).cast<float>(), code});
  });
  return picture;
}

/// The delayed pass of a method that judges at once: after each scan, the one of `delay` scans ago.
class DelayedPass {
 public:
  DelayedPass(LabelledSequence& sequence, const RemovalMethod& method, std::size_t delay)
      : sequence_(sequence), method_(method), delay_(delay) {}
  void after(std::size_t k, std::optional<PassScore>& score) const {
    if (delay_ == 0) return;
    if (k >= delay_) judge(k - delay_, score);
    if (k + 1 < sequence_.size()) return;
    for (std::size_t left = k < delay_ ? 0 : k - delay_ + 1; left <= k; ++left) judge(left, score);
  }

 private:
  void judge(std::size_t k, std::optional<PassScore>& score) const {
    const LabelledFrame scan = sequence_.read(k);
    if (!score) score.emplace();
    score->add(scan.frame, scan.labels_now, method_.map_verdicts(k, scan.frame));
  }

  LabelledSequence& sequence_;
  const RemovalMethod& method_;
  std::size_t delay_;
};

}  // namespace

MethodResult run_method(LabelledSequence& sequence, const MethodChoice& choice, const RunOptions& options,
                        const std::function<void()>& advance) {
  MethodResult result;
  result.method = choice.name;
  const MemoryMeter memory;
  CpuMeter at_once, after;
  const std::unique_ptr<RemovalMethod> method = choice.make();
  const DelayedPass delayed(sequence, *method, options.delay);
  for (std::size_t k = 0; k < sequence.size(); ++k, advance()) {
    const LabelledFrame scan = sequence.read(k);
    at_once.start();
    const std::optional<PointVerdicts> verdicts = method->add(scan.frame);
    at_once.stop();
    if (!verdicts) continue;
    if (!result.at_once) result.at_once.emplace();
    result.at_once->add(scan.frame, scan.labels_now, *verdicts);
    delayed.after(k, result.delayed);
  }
  after.start();
  method->finish();
  after.stop();

  std::vector<std::vector<Label>> final_verdicts;
  for (std::size_t k = 0; k < sequence.size(); ++k, advance()) {
    const LabelledFrame scan = sequence.read(k);
    after.start();
    PointVerdicts verdicts = method->map_verdicts(k, scan.frame);
    after.stop();
    result.final.add(scan.frame, scan.labels, verdicts);
    final_verdicts.push_back(std::move(verdicts.label));
  }
  const auto scans = static_cast<double>(sequence.size());
  result.cost = {at_once.total_ms() / scans, (at_once.total_ms() + after.total_ms()) / scans,
                 memory.peak_mb()};
  result.settings = method->settings();

  if (options.brief) return result;
  result.map_wise_kept = count_map_wise(sequence, final_verdicts, options.map_voxel_size_m, Uncertain::kKept);
  result.map_wise_dropped =
      count_map_wise(sequence, final_verdicts, options.map_voxel_size_m, Uncertain::kDropped);
  result.picture = take_picture(sequence, final_verdicts, options);
  return result;
}

}  // namespace stillmap
