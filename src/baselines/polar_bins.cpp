#include "baselines/polar_bins.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace stillmap {

int PolarBins::Layout::bin_of(const Eigen::Vector3d& upright) const {
  constexpr double kPi = 3.14159265358979;
  const double range_m = upright.head<2>().norm();
  if (range_m >= max_range_m || upright.z() < min_z_m || upright.z() > max_z_m) return -1;
  const int ring = static_cast<int>(range_m / max_range_m * rings);
  const double turn = (std::atan2(upright.y(), upright.x()) + kPi) / (2 * kPi);
  const int sector = std::min(sectors - 1, static_cast<int>(turn * sectors));
  return std::min(ring, rings - 1) * sectors + sector;
}

void PolarBins::add(const Eigen::Vector3d& upright, std::uint32_t member) {
  const int index = layout_.bin_of(upright);
  if (index < 0) return;
  Bin& bin = bins_[static_cast<std::size_t>(index)];
  bin.lowest_m = std::min(bin.lowest_m, upright.z());
  bin.highest_m = std::max(bin.highest_m, upright.z());
  bin.members.push_back(member);
}

double ground_below_m(const std::vector<Eigen::Vector3d>& upright_returns) {
  constexpr double kCell_m = 2.0, kReach_m = 12.0;
  std::map<std::pair<int, int>, double> lowest_m;
  for (const Eigen::Vector3d& point : upright_returns) {
    if (point.head<2>().norm() > kReach_m) continue;
    const std::pair<int, int> cell(static_cast<int>(std::floor(point.x() / kCell_m)),
                                   static_cast<int>(std::floor(point.y() / kCell_m)));
    const auto [entry, created] = lowest_m.try_emplace(cell, point.z());
    if (!created) entry->second = std::min(entry->second, point.z());
  }
  if (lowest_m.empty()) return 0;
  std::vector<double> heights_m;
  heights_m.reserve(lowest_m.size());
  for (const auto& entry : lowest_m) heights_m.push_back(entry.second);
  const auto middle = heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / 2);
  std::nth_element(heights_m.begin(), middle, heights_m.end());
  return *middle;
}

}  // namespace stillmap
