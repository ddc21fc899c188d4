#pragma once

#include "evaluation/injected_target.hpp"
#include "evaluation/labelled_sequence.hpp"

namespace stillmap {

/// Targets as in section 2.1 of the paper. It gives no speed for the vehicle and no paths.
struct InjectionOptions {
  int people = 2;
  std::size_t person_points = 260;
  double person_height_m = 1.72;
  int vehicles = 1;
  std::size_t vehicle_points = 420;
  std::vector<double> vehicle_size_m = {1.8, 0.9, 1.5};
  double speed_mps = 0.8;
  bool overlay = false;           ///< the paper's: points all over each target, hiding and hidden by nothing
  std::size_t max_points = 9000;  ///< of the recorded scan, after the targets hid what is behind; 0 = all
  std::uint64_t seed = 7;
};

/// A recorded sequence with moving targets put in. Unless overlaid, they hide what is behind them and are
/// hidden by what is before them. The targets' rows come after the scan's own.
class InjectedSequence : public LabelledSequence {
 public:
  /// Throws std::runtime_error when there is no place for a target, std::invalid_argument on bad options.
  InjectedSequence(std::unique_ptr<LabelledSequence> background, const InjectionOptions& options);
  std::size_t size() const override { return background_->size(); }
  LabelledFrame read(std::size_t index) override;

 private:
  void hide_behind_targets(LabelledFrame& scan, double time_s) const;
  bool is_behind_another(const InjectedTarget& target, const Eigen::Vector3d& origin,
                         const Eigen::Vector3d& place, double time_s) const;

  std::unique_ptr<LabelledSequence> background_;
  InjectionOptions options_;
  std::vector<InjectedTarget> targets_;
  std::int64_t first_stamp_ns_ = 0;
};

/// A sequence without truth: everything in it counts as standing ("other object").
class StandingSequence : public LabelledSequence {
 public:
  explicit StandingSequence(std::unique_ptr<Sequence> scans) : scans_(std::move(scans)) {}
  std::size_t size() const override { return scans_->size(); }
  LabelledFrame read(std::size_t index) override;

 private:
  std::unique_ptr<Sequence> scans_;
};

}  // namespace stillmap
