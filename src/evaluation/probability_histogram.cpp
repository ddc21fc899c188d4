#include "evaluation/probability_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stillmap {
namespace {

using Counts = std::array<std::size_t, ProbabilityHistogram::kBins>;

std::size_t sum(const Counts& counts, int from, int to) {
  return std::accumulate(counts.begin() + from, counts.begin() + to, std::size_t{0});
}

}  // namespace

void ProbabilityHistogram::add(float p_static, bool truth_is_dynamic) {
  if (std::isnan(p_static)) return;
  const auto bin = static_cast<std::size_t>(
      std::clamp(static_cast<int>(p_static * static_cast<float>(kBins)), 0, kBins - 1));
  ++(truth_is_dynamic ? dynamic_ : static_)[bin];
  p_sum_[bin] += p_static;
  ++points_;
}

Percent ProbabilityHistogram::pr_at(int threshold_percent) const {
  return percent(sum(static_, threshold_percent, kBins), sum(static_, 0, kBins));
}

Percent ProbabilityHistogram::rr_at(int threshold_percent) const {
  return percent(sum(dynamic_, 0, threshold_percent), sum(dynamic_, 0, kBins));
}

std::array<ProbabilityHistogram::Decile, 10> ProbabilityHistogram::deciles() const {
  std::array<Decile, 10> deciles;
  constexpr int kWidth = kBins / 10;
  for (int i = 0; i < 10; ++i) {
    const int from = i * kWidth, to = from + kWidth;
    const std::size_t is_static = sum(static_, from, to);
    Decile& decile = deciles[static_cast<std::size_t>(i)];
    decile.points = is_static + sum(dynamic_, from, to);
    if (decile.points == 0) continue;
    const auto points = static_cast<double>(decile.points);
    decile.mean_p_static = std::accumulate(p_sum_.begin() + from, p_sum_.begin() + to, 0.0) / points;
    decile.static_share = static_cast<double>(is_static) / points;
  }
  return deciles;
}

std::optional<double> ProbabilityHistogram::expected_calibration_error() const {
  if (empty()) return std::nullopt;
  double error = 0;
  for (const Decile& decile : deciles())
    error += static_cast<double>(decile.points) * std::abs(decile.mean_p_static - decile.static_share);
  return error / static_cast<double>(points_);
}

}  // namespace stillmap
