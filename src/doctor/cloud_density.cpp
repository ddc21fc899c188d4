#include "doctor/cloud_density.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "stillmap/projection.hpp"

namespace stillmap {
namespace {

constexpr float kNearest_m = 1.0F, kCell_m = 0.06F;
constexpr double kNearShare = 0.3;  // of the points
// Whole scans of seven kinds of sensor reach 0.65 and more, thinned to 0.1 m at most 0.25.
constexpr double kWhole = 0.3;
// The returns in a direction do not get fewer with nearness: the exponent of their number over range is -0.2
// to 0.45 in whole scans, and 0.45 to 2 in thinned ones.
constexpr double kThinned = 0.42;
constexpr std::size_t kEnough = 300;

std::vector<float> ranges_of(const Scan& scan) {
  std::vector<float> ranges;
  for (const Eigen::Vector3f& point : scan.points)
    if (point.allFinite() && point.norm() > kNearest_m) ranges.push_back(point.norm());
  return ranges;
}

/// The share of points within `range_m` that are not alone in their cell.
double shared_cells(const Scan& scan, float range_m) {
  std::vector<std::array<int, 3>> cells;
  for (const Eigen::Vector3f& point : scan.points)
    if (point.allFinite() && point.norm() > kNearest_m && point.norm() <= range_m)
      cells.push_back({int(std::floor(point.x() / kCell_m)), int(std::floor(point.y() / kCell_m)),
                       int(std::floor(point.z() / kCell_m))});
  std::sort(cells.begin(), cells.end());
  std::size_t shared = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    shared += (i > 0 && cells[i] == cells[i - 1]) || (i + 1 < cells.size() && cells[i] == cells[i + 1]);
  return double(shared) / double(cells.size());
}

/// The exponent of the number of returns in a direction over their range; 0 where there is too little to
/// tell.
double returns_over_range(const Scan& scan) {
  constexpr float kCell_rad = 0.07F;
  struct Cell {
    double sum_m = 0;
    int count = 0;
  };
  std::map<std::pair<int, int>, Cell> cells;
  for (const Eigen::Vector3f& point : scan.points) {
    if (!point.allFinite() || point.norm() < kNearest_m) continue;
    const Spherical seen = spherical(point);
    Cell& cell = cells[{int(std::floor(seen.azimuth_rad / kCell_rad)),
                        int(std::floor(seen.elevation_rad / kCell_rad))}];
    cell.sum_m += double(seen.range_m);
    ++cell.count;
  }
  std::vector<std::pair<double, int>> by_range;
  for (const auto& [key, cell] : cells)
    if (cell.count > 1) by_range.push_back({cell.sum_m / cell.count, cell.count});
  if (by_range.size() < kEnough / 10) return 0;
  std::sort(by_range.begin(), by_range.end());
  const std::size_t third = by_range.size() / 3;
  const auto mean_count = [&](std::size_t from) {
    double sum = 0;
    for (std::size_t i = from; i < from + third; ++i) sum += by_range[i].second;
    return sum / double(third);
  };
  const double near_m = by_range[third / 2].first, far_m = by_range[by_range.size() - 1 - third / 2].first;
  return std::log(mean_count(by_range.size() - third) / mean_count(0)) / std::log(far_m / near_m);
}

}  // namespace

std::optional<Finding> check_density(const Scan& scan) {
  std::vector<float> ranges = ranges_of(scan);
  if (ranges.size() < kEnough) return std::nullopt;
  const auto nth = ranges.begin() + static_cast<std::ptrdiff_t>(kNearShare * double(ranges.size()));
  std::nth_element(ranges.begin(), nth, ranges.end());
  const double shared = shared_cells(scan, *nth);
  if (shared >= kWhole || returns_over_range(scan) < kThinned) return std::nullopt;
  std::ostringstream text;
  text << "the cloud of " << ranges.size()
       << " points looks thinned, or like features only: of those nearer than " << std::lround(*nth) << " m, "
       << std::lround(100 * shared) << " % have another within " << 100 * kCell_m
       << " cm; set cloud_topic to the package's whole cloud (doc/odometry.md), or switch its filter off";
  return Finding{"density", text.str()};
}

}  // namespace stillmap
