#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "simulation/surface.hpp"

namespace stillmap::simulation {

struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< of length 1, so that a parameter along it is a range in metres
};

/// Where a ray enters a shape.
struct Crossing {
  double range_m;
  double incidence_cos;  ///< of the angle between the ray and the surface's normal, 0 to 1
};

enum class ShapeKind : std::uint8_t { kBox, kCylinder, kCapsule, kEllipsoid, kDisc };

/// A convex solid (or a disc) in its parent's frame: the map, or the body of a mover. A ray that starts
/// inside leaves unhindered.
struct Shape {
  ShapeKind kind;
  /// Half edges of a box; cylinder and capsule along z: (radius, radius, half length, without a capsule's
  /// round ends); semi-axes of an ellipsoid; (radius, radius, 0) of a disc with normal z.
  Eigen::Vector3d half_size_m;
  Eigen::Vector3d center;
  Eigen::Matrix3d R_parent_shape = Eigen::Matrix3d::Identity();
  Surface surface;

  std::optional<Crossing> cross(const Ray& ray) const;
  Eigen::AlignedBox3d bounds() const;  ///< in the parent's frame
};

Shape make_box(const Eigen::Isometry3d& T_parent_box, const Eigen::Vector3d& size_m, const Surface& surface);
/// Stands along z of its frame, centred.
Shape make_cylinder(const Eigen::Isometry3d& T_parent_cylinder, double radius_m, double height_m,
                    const Surface& surface);
Shape make_cylinder_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_m,
                            const Surface& surface);
/// Round ends around `from` and `to`.
Shape make_capsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_m,
                   const Surface& surface);
Shape make_ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& semi_axes_m,
                     const Surface& surface);
Shape make_disc(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double radius_m,
                const Surface& surface);

/// A pose at (x, y, z), turned by yaw about z.
Eigen::Isometry3d pose_at(double x, double y, double z, double yaw_rad = 0);

}  // namespace stillmap::simulation
