#include "doctor/rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace stillmap {
namespace {

constexpr double kManyAtOnePlace = 0.02, kNearlyAll = 0.9;
constexpr std::size_t kEnough = 100;

bool is_return(const Eigen::Vector3f& point) {
  return point.allFinite() && !point.isZero(0);
}

/// The longest run of equal points, to the centimetre: moving a row to and fro rounds it.
std::size_t most_at_one_place(const Scan& scan, Eigen::Vector3f& place) {
  std::vector<std::array<int, 3>> cells;
  for (const Eigen::Vector3f& point : scan.points)
    if (is_return(point) && point.norm() < 1000.0F)
      cells.push_back({int(std::lround(point.x() * 100)), int(std::lround(point.y() * 100)),
                       int(std::lround(point.z() * 100))});
  std::sort(cells.begin(), cells.end());
  std::size_t most = 0, run = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    run = i > 0 && cells[i] == cells[i - 1] ? run + 1 : 1;
    if (run <= most) continue;
    most = run;
    place = Eigen::Vector3f(float(cells[i][0]), float(cells[i][1]), float(cells[i][2])) / 100.0F;
  }
  return most;
}

int percent(std::size_t part, std::size_t all) {
  return static_cast<int>(std::lround(100.0 * double(part) / double(all)));
}

}  // namespace

std::optional<Finding> check_rows(const Scan& scan) {
  if (scan.points.size() < kEnough) return std::nullopt;
  const auto returns = std::count_if(scan.points.begin(), scan.points.end(), is_return);
  const std::size_t empty = scan.points.size() - static_cast<std::size_t>(returns);
  std::ostringstream text;
  if (double(empty) > kNearlyAll * double(scan.points.size())) {
    text << percent(empty, scan.points.size())
         << " % of the rows are NaN or zero; check the sensor's driver and "
         << "its range limits";
    return Finding{"rows", text.str()};
  }
  Eigen::Vector3f place = Eigen::Vector3f::Zero();
  const std::size_t most = most_at_one_place(scan, place);
  if (double(most) < kManyAtOnePlace * double(scan.points.size())) return std::nullopt;
  text << percent(most, scan.points.size()) << " % of the rows are one point, (" << place.transpose()
       << ") from the sensor: rows without a return were moved as if they were points; leave them out or NaN "
          "in "
       << "the package that makes the cloud, or raise min_range_m above " << place.norm();
  return Finding{"rows", text.str()};
}

}  // namespace stillmap
