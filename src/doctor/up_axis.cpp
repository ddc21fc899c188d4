#include "doctor/up_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

namespace stillmap {
namespace {

constexpr float kReach_m = 15.0F, kSlab_m = 0.2F, kNearestPlane_m = 0.2F, kFarthestPlane_m = 5.0F;
constexpr std::size_t kWide_m2 = 150;  // no wall of a room, no facade within reach
constexpr double kClearly = 3.0;       // facades of an alley reach twice its ground

/// Square metres of the widest slab across `axis`, at either side of the sensor.
std::size_t widest_slab_m2(const std::vector<Eigen::Vector3f>& points, int axis) {
  constexpr int kSlabs = 2 * int(kFarthestPlane_m / kSlab_m) + 1;
  std::array<std::set<std::pair<int, int>>, kSlabs> cells;
  for (const Eigen::Vector3f& upright : points) {
    if (upright.norm() > kReach_m || upright.norm() < 0.5F) continue;
    const float along = upright[axis];
    if (std::abs(along) < kNearestPlane_m || std::abs(along) >= kFarthestPlane_m) continue;
    const int slab = int(std::floor(along / kSlab_m)) + kSlabs / 2;
    if (slab < 0 || slab >= kSlabs) continue;
    cells[static_cast<std::size_t>(slab)].insert(
        {int(std::floor(upright[(axis + 1) % 3])), int(std::floor(upright[(axis + 2) % 3]))});
  }
  std::size_t widest = 0;  // a plane may lie across two slabs
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
    std::set<std::pair<int, int>> both = cells[i];
    both.insert(cells[i + 1].begin(), cells[i + 1].end());
    widest = std::max(widest, both.size());
  }
  return widest;
}

}  // namespace

WidestPlane widest_plane(const std::vector<Eigen::Vector3f>& upright) {
  const std::size_t x = widest_slab_m2(upright, 0), y = widest_slab_m2(upright, 1);
  WidestPlane plane;
  plane.level_m2 = widest_slab_m2(upright, 2);
  plane.m2 = std::max(x, y);
  if (plane.m2 >= kWide_m2 && double(plane.m2) >= kClearly * double(plane.level_m2))
    plane.lies_across = x > y ? 'x' : 'y';
  return plane;
}

std::optional<Finding> check_up_axis(const Scan& scan, const Eigen::Isometry3d& T_map_sensor,
                                     const PairingOptions& said) {
  const Eigen::Matrix3f R_map_sensor = T_map_sensor.linear().cast<float>();
  std::vector<Eigen::Vector3f> upright;
  for (const Eigen::Vector3f& point : scan.points)
    if (point.allFinite()) upright.push_back(R_map_sensor * point);
  const WidestPlane plane = widest_plane(upright);
  if (plane.lies_across == 'z') return std::nullopt;
  const bool is_ros = said.R_ros_odometry.isIdentity();
  std::ostringstream text;
  text << "the ground lies across " << plane.lies_across << " instead of z (" << plane.m2 << " m2 against "
       << plane.level_m2 << "): the axes are turned; set odometry_axes to " << (is_ros ? "loam" : "ros")
       << (is_ros ? " if the package has LOAM's axes (x left, y up)" : "")
       << ", or give the sensor's rotation in sensor_on_body";
  return Finding{"axes", text.str(), {{"odometry_axes", is_ros ? "loam" : "ros"}}};
}

}  // namespace stillmap
