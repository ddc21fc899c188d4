#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "stillmap/projection.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// A small motion in the map frame: a turn about the sensor, then a shift.
struct SmallMotion {
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero(), shift_m = Eigen::Vector3d::Zero();

  SmallMotion operator-(const SmallMotion& other) const {
    return {turn_rad - other.turn_rad, shift_m - other.shift_m};
  }
  /// How far it moves what lies where the static surface is known best.
  double reach_m() const {
    constexpr double kAway_m = 20.0;
    return shift_m.norm() + kAway_m * turn_rad.norm();
  }
  Eigen::Isometry3d applied_to(const Eigen::Isometry3d& T_map_sensor) const;
};

/// How the poses of a LiDAR were off in the scans before.
struct PoseJumps {
  SmallMotion usual;          ///< on average: slow drift shows so
  double mean_square_m2 = 0;  ///< of what exceeds it
  bool any_taken_back = false;
};

/// Finds how far a scan's pose is off against surface that the map believes to stand: some returns, each
/// against the plane of the voxels around.
class ScanAlignment {
 public:
  explicit ScanAlignment(const VoxelMap& map) : map_(map) {}

  /// What takes the scan onto the map; nothing where too little of the map is known.
  std::optional<SmallMotion> find(const ProjectedScan& scan, const Eigen::Isometry3d& T_map_sensor) const;
  /// How many of some returns lie on the plane of the voxels around.
  int agreeing(const ProjectedScan& scan, const Eigen::Isometry3d& T_map_sensor) const;

 private:
  struct Plane {
    Eigen::Vector3d normal;
    double distance_m;  ///< of it from the return, along the normal
  };
  std::optional<Plane> plane_near(const Eigen::Vector3d& point_map_m) const;
  std::optional<SmallMotion> step(const std::vector<Eigen::Vector3d>& points_m,
                                  const Eigen::Isometry3d& T_map_sensor, const SmallMotion& so_far) const;

  const VoxelMap& map_;
};

}  // namespace stillmap
