#include <cmath>
#include <limits>

#include "for_rows.hpp"
#include "mapper_state.hpp"

namespace stillmap {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// The upright box around the points with the smallest floor.
MovingBox smallest_box(const Points& points) {
  constexpr int kTurns = 30;
  constexpr double kQuarter_rad = 1.57079632679;
  MovingBox best;
  double least_m2 = std::numeric_limits<double>::max();
  for (int turn = 0; turn < kTurns; ++turn) {
    const Eigen::Matrix3d R_map_box =
        Eigen::AngleAxisd(kQuarter_rad * turn / kTurns, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    Eigen::AlignedBox3d turned;
    for (const Eigen::Vector3d& point : points) turned.extend(R_map_box.transpose() * point);
    const double floor_m2 = turned.sizes().x() * turned.sizes().y();
    if (floor_m2 >= least_m2) continue;
    least_m2 = floor_m2;
    best.T_map_box.linear() = R_map_box;
    best.T_map_box.translation() = R_map_box * turned.center();
    best.size_m = turned.sizes();
  }
  best.points = points.size();
  return best;
}

}  // namespace

std::vector<MovingBox> Mapper::moving_boxes(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) const {
  constexpr std::size_t kLeastPoints = 5;
  const State& s = *state_;
  if (scan.points.size() != s.labels.label.size()) return {};  // not the scan of the last process()
  std::vector<std::uint32_t> moves;
  find_rows(scan.points.size(), moves,
            [&](std::size_t row) { return s.labels.label[row] == Label::kDynamic; });
  Clusters things;
  things.find(s.projected, s.beams, moves);
  std::vector<Points> points(things.count());
  for (const std::uint32_t row : moves)
    if (things.of_row()[row] != Clusters::kNone)
      points[things.of_row()[row]].push_back(T_map_sensor * scan.points[row].cast<double>());
  std::vector<MovingBox> boxes;
  for (const Points& of_thing : points)
    if (of_thing.size() >= kLeastPoints) boxes.push_back(smallest_box(of_thing));
  return boxes;
}

}  // namespace stillmap
