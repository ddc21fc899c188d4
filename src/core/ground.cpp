#include "ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "for_rows.hpp"
#include "vector_clones.hpp"

namespace stillmap {
namespace {

constexpr float kNothing = std::numeric_limits<float>::max();

/// One axis of n points in another frame; `axis` is that axis in their own.
// NOLINTNEXTLINE(performance-unnecessary-value-param): a copy stays in registers
STILLMAP_VECTOR_CLONES void turn_onto(const Eigen::Vector3f axis, std::size_t n, const float* __restrict x,
                                      const float* __restrict y, const float* __restrict z,
                                      float* __restrict turned) {
  const float ax = axis.x(), ay = axis.y(), az = axis.z();
  for (std::size_t i = 0; i < n; ++i) turned[i] = ax * x[i] + (ay * y[i] + az * z[i]);
}

STILLMAP_VECTOR_CLONES void find_cells(std::size_t n, const float* __restrict range_m,
                                       const float* __restrict x, const float* __restrict y,
                                       std::int16_t* __restrict cell) {
  constexpr float kPi = 3.14159265358979F;
  constexpr float kLastSector = Ground::kSectors - 1, kBeyond = Ground::kRings;
  for (std::size_t i = 0; i < n; ++i) {
    const float turn = (fast_atan2(y[i], x[i]) + kPi) / (2 * kPi) * Ground::kSectors;
    const float flat = std::sqrt(x[i] * x[i] + y[i] * y[i]) / Ground::kRingM;
    const int sector = static_cast<int>(turn < kLastSector ? std::max(turn, 0.0F) : kLastSector);
    const int ring = static_cast<int>(flat < kBeyond ? flat : kBeyond);  // NaN is beyond, too
    const bool within = (ring < Ground::kRings) & (range_m[i] > 0);
    cell[i] = static_cast<std::int16_t>(within ? sector * Ground::kRings + ring : -1);
  }
}

/// Calls work(first, last) for shares of the cells, one for each thread: what is gathered in a cell is
/// gathered in the order of the rows.
template <class Work>
void for_shares_of_cells(Work&& work) {
  constexpr int kCells = Ground::kSectors * Ground::kRings;
  const int shares = arena_threads();
  for_each_index(static_cast<std::size_t>(shares), [&](std::size_t i) {
    const auto share = static_cast<int>(i);
    work(kCells * share / shares, kCells * (share + 1) / shares);
  });
}

}  // namespace

void UprightRows::turn(const ProjectedScan& scan, const Eigen::Matrix3f& R_map_sensor) {
  for (std::vector<float>* axis : {&x_m, &y_m, &z_m}) axis->resize(scan.size());
  ground_cell.resize(scan.size());
  for_rows(scan.size(), [&](std::size_t first, std::size_t last) {
    constexpr std::size_t kAtOnce = 512;  // stays in the cache from one axis to the next
    std::vector<float>* const axes[] = {&x_m, &y_m, &z_m};
    for (; first < last; first += kAtOnce) {
      const std::size_t n = std::min(kAtOnce, last - first);
      for (int a = 0; a < 3; ++a)
        turn_onto(R_map_sensor.row(a), n, &scan.x_m[first], &scan.y_m[first], &scan.z_m[first],
                  &(*axes[a])[first]);
      find_cells(n, &scan.range_m[first], &x_m[first], &y_m[first], &ground_cell[first]);
    }
  });
}

void Ground::fit(const UprightRows& rows) {
  lowest_.assign(kSectors * kRings, kNothing);
  highest_.assign(kSectors * kRings, -kNothing);
  height_.assign(kSectors * kRings, 0.0F);
  for_shares_of_cells([&](int first, int last) {
    for (std::size_t i = 0; i < rows.z_m.size(); ++i) {
      const int cell = rows.ground_cell[i];
      if (cell < first || cell >= last) continue;
      lowest_[cell] = std::min(lowest_[cell], rows.z_m[i]);
      highest_[cell] = std::max(highest_[cell], rows.z_m[i]);
    }
  });
  const float seed = seed_height();
  for (int sector = 0; sector < kSectors; ++sector) walk(sector, seed);
  settle_on_returns(rows);
}

void Ground::settle_on_returns(const UprightRows& rows) {
  // The lowest return lies a few sigmas low: take the mean of what lies close to it.
  constexpr float kBelowM = 0.05F, kAboveM = 0.12F;
  sum_.assign(height_.size(), 0.0F);
  count_.assign(height_.size(), 0.0F);
  for_shares_of_cells([&](int first, int last) {
    for (std::size_t i = 0; i < rows.z_m.size(); ++i) {
      const int cell = rows.ground_cell[i];
      if (cell < first || cell >= last) continue;
      const float above = rows.z_m[i] - height_[cell];
      if (above <= -kBelowM || above >= kAboveM) continue;
      sum_[cell] += above;
      count_[cell] += 1;
    }
  });
  for (std::size_t cell = 0; cell < height_.size(); ++cell)
    if (count_[cell] > 0) height_[cell] += sum_[cell] / count_[cell];
}

float Ground::seed_height() const {
  // A low cell, but not the lowest, since a few may lie below the ground (reflections). Most may lie above: a
  // sensor that hardly looks down sees the ground far off only, and the sides of what is near. What lies low
  // at the foot of a slope does not count as lower.
  constexpr int kAroundRings = 30;
  constexpr float kSlope = 0.08F;
  constexpr double kLow = 0.05;
  std::vector<std::pair<float, float>> cells;  // how low for its distance, height
  for (int sector = 0; sector < kSectors; ++sector)
    for (int ring = 0; ring < kAroundRings; ++ring) {
      const float lowest = lowest_[sector * kRings + ring];
      if (lowest < kNothing) cells.emplace_back(lowest + kSlope * kRingM * static_cast<float>(ring), lowest);
    }
  if (cells.empty()) return 0;
  const auto low = cells.begin() + static_cast<std::ptrdiff_t>(kLow * static_cast<double>(cells.size()));
  std::nth_element(cells.begin(), low, cells.end());
  return low->second;
}

void Ground::walk(int sector, float seed) {
  constexpr float kSlope = 0.18F, kRoughM = 0.15F, kFlatM = 0.3F;
  constexpr int kSlopeGoesOnRings = 5;   // farther, what stands there alone is more likely
  constexpr int kGoesOnUnderThings = 1;  // it may be a side, met far above the ground
  steps_.clear();
  steps_.push_back({-1, seed});
  for (int ring = 0; ring < kRings; ++ring) {
    const float lowest = lowest_[sector * kRings + ring];
    const Step& last = steps_.back();
    const bool is_flat = highest_[sector * kRings + ring] - lowest < kFlatM;
    const int goes_on = std::min(ring - last.ring, is_flat ? kSlopeGoesOnRings : kGoesOnUnderThings);
    const float reach = kRoughM + kSlope * kRingM * static_cast<float>(goes_on);
    if (lowest < kNothing && std::abs(lowest - last.height_m) <= reach) {
      steps_.push_back({ring, lowest});
      forget_bump();
    }
  }
  float* const height = &height_[sector * kRings];
  for (std::size_t i = 0; i + 1 < steps_.size(); ++i)
    for (int ring = steps_[i].ring + 1; ring <= steps_[i + 1].ring; ++ring)
      height[ring] = between(steps_[i], steps_[i + 1], ring);
  std::fill(height + steps_.back().ring + 1, height + kRings, steps_.back().height_m);
}

// The ground goes on behind a thing that stands on it: what rises above the line from the step before to the
// one behind was a leg, hit between two rings on the ground.
void Ground::forget_bump() {
  constexpr float kBumpM = 0.07F;
  while (steps_.size() >= 3) {
    const Step &before = *(steps_.end() - 3), &middle = *(steps_.end() - 2), &behind = steps_.back();
    if (middle.height_m - between(before, behind, middle.ring) <= kBumpM) return;
    steps_.erase(steps_.end() - 2);
  }
}

float Ground::between(const Step& a, const Step& b, int ring) {
  return a.height_m +
         (b.height_m - a.height_m) * static_cast<float>(ring - a.ring) / static_cast<float>(b.ring - a.ring);
}

void Ground::heights_above(const UprightRows& rows, std::vector<float>& height_m) const {
  height_m.resize(rows.z_m.size());
  for_rows(height_m.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const int cell = rows.ground_cell[i];
      height_m[i] = cell < 0 ? std::numeric_limits<float>::infinity() : rows.z_m[i] - height_[cell];
    }
  });
}

float Ground::height_beside_m(int cell) const {
  const int sector = cell / kRings, ring = cell % kRings;
  // What the beams that were stopped would have hit lies as far away, or a little farther.
  for (const int at_ring : {ring, std::min(ring + 1, kRings - 1), std::max(ring - 1, 0)}) {
    const int left = lower_beside(sector, at_ring, -1), right = lower_beside(sector, at_ring, 1);
    if (left >= 0 && right >= 0) return 0.5F * (height_[left] + height_[right]);
  }
  return height_[cell];
}

// What stands in a cell may reach into the next.
int Ground::lower_beside(int sector, int ring, int step) const {
  constexpr int kSectorsAway = 3, kCells = 2;
  int lower = -1;
  for (int away = 1, cells = 0; away <= kSectorsAway && cells < kCells; ++away) {
    const int cell = (sector + away * step + kSectors) % kSectors * kRings + ring;
    if (count_[cell] <= 0) continue;
    ++cells;
    if (lower < 0 || height_[cell] < height_[lower]) lower = cell;
  }
  return lower;
}

}  // namespace stillmap
