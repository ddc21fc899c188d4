#include "ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillmap {
namespace {

constexpr float kNothing = std::numeric_limits<float>::max();

}  // namespace

int Ground::cell_of(const Eigen::Vector3f& upright) {
  constexpr float kPi = 3.14159265358979F;
  const float turn = (fast_atan2(upright.y(), upright.x()) + kPi) / (2 * kPi);
  const int sector = std::clamp(static_cast<int>(turn * kSectors), 0, kSectors - 1);
  const int ring = static_cast<int>(upright.head<2>().norm() / kRingM);
  return ring < kRings ? sector * kRings + ring : -1;
}

void Ground::fit(const Scan& scan, const ProjectedScan& projected, const Eigen::Matrix3f& R_map_sensor) {
  lowest_.assign(kSectors * kRings, kNothing);
  height_.assign(kSectors * kRings, 0.0F);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!(projected.range_m[i] > 0)) continue;
    const Eigen::Vector3f upright = R_map_sensor * scan.points[i];
    const int cell = cell_of(upright);
    if (cell >= 0) lowest_[cell] = std::min(lowest_[cell], upright.z());
  }
  const float seed = seed_height();
  for (int sector = 0; sector < kSectors; ++sector) walk(sector, seed);
  settle_on_returns(scan, projected, R_map_sensor);
}

void Ground::settle_on_returns(const Scan& scan, const ProjectedScan& projected,
                               const Eigen::Matrix3f& R_map_sensor) {
  // The lowest return lies a few sigmas low: take the mean of what lies close to it.
  constexpr float kBelowM = 0.05F, kAboveM = 0.12F;
  sum_.assign(height_.size(), 0.0F);
  count_.assign(height_.size(), 0.0F);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!(projected.range_m[i] > 0)) continue;
    const Eigen::Vector3f upright = R_map_sensor * scan.points[i];
    const int cell = cell_of(upright);
    const float above = cell < 0 ? kAboveM : upright.z() - height_[cell];
    if (above <= -kBelowM || above >= kAboveM) continue;
    sum_[cell] += above;
    count_[cell] += 1;
  }
  for (std::size_t cell = 0; cell < height_.size(); ++cell)
    if (count_[cell] > 0) height_[cell] += sum_[cell] / count_[cell];
}

float Ground::seed_height() const {
  // The low cells of the near field: a quantile, since a few may lie below the ground (reflections) and many
  // above.
  std::vector<float> near;
  for (int sector = 0; sector < kSectors; ++sector)
    for (int ring = 0; ring < 15; ++ring)
      if (lowest_[sector * kRings + ring] < kNothing) near.push_back(lowest_[sector * kRings + ring]);
  if (near.empty()) return 0;
  const auto nth = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 5);
  std::nth_element(near.begin(), nth, near.end());
  return *nth;
}

void Ground::walk(int sector, float seed) {
  constexpr float kSlope = 0.18F, kRoughM = 0.15F;
  float height = seed;
  int since = 1;
  for (int ring = 0; ring < kRings; ++ring, ++since) {
    const int cell = sector * kRings + ring;
    const float step = kRoughM + kSlope * kRingM * static_cast<float>(std::min(since, 10));
    const float lowest = lowest_[cell];
    if (lowest < kNothing && std::abs(lowest - height) <= step) {
      height = lowest;
      since = 0;
    }
    height_[cell] = height;
  }
}

float Ground::height_above(const Eigen::Vector3f& upright) const {
  const int cell = cell_of(upright);
  return cell < 0 ? std::numeric_limits<float>::infinity() : upright.z() - height_[cell];
}

}  // namespace stillmap
