#pragma once

#include <array>
#include <cstddef>

#include "evaluation/confusion.hpp"

namespace stillmap {

/// How often points of each p_static are truly static. Rows without a p_static are left out.
class ProbabilityHistogram {
 public:
  static constexpr int kBins = 100;

  void add(float p_static, bool truth_is_dynamic);
  /// Points with p_static in [bin, bin + 1) / kBins.
  std::size_t static_in(std::size_t bin) const { return static_[bin]; }
  std::size_t dynamic_in(std::size_t bin) const { return dynamic_[bin]; }
  bool empty() const { return points_ == 0; }

  /// PR and RR if a point were removed below this threshold (a whole percent, 0 to 100).
  Percent pr_at(int threshold_percent) const;
  Percent rr_at(int threshold_percent) const;

  /// One of ten equal bins of p_static: what was claimed, and what is true.
  struct Decile {
    std::size_t points = 0;
    double mean_p_static = 0, static_share = 0;
  };
  std::array<Decile, 10> deciles() const;
  /// Mean over points of |claimed - true| of their decile; 0 to 1.
  std::optional<double> expected_calibration_error() const;

 private:
  std::size_t points_ = 0;
  std::array<std::size_t, kBins> static_{}, dynamic_{};
  std::array<double, kBins> p_sum_{};
};

}  // namespace stillmap
