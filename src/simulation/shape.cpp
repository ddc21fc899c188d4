#include "simulation/shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillmap::simulation {
namespace {

using Eigen::Vector3d;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The part of a ray inside a convex body; `normal` is the surface's where the ray enters.
struct Inside {
  double enter = -kInfinity;
  double leave = kInfinity;
  Vector3d normal = Vector3d::Zero();
};

/// Keeps the part between the planes at -half and +half of one axis. False where nothing is left.
bool clip_slab(const Vector3d& origin, const Vector3d& direction, int axis, double half, Inside* inside) {
  if (std::abs(direction[axis]) < 1e-12) return std::abs(origin[axis]) <= half;
  const double side = direction[axis] > 0 ? -1.0 : 1.0;
  const double enter = (side * half - origin[axis]) / direction[axis];
  const double leave = (-side * half - origin[axis]) / direction[axis];
  if (enter > inside->enter) {
    inside->enter = enter;
    inside->normal = side * Vector3d::Unit(axis);
  }
  inside->leave = std::min(inside->leave, leave);
  return inside->enter <= inside->leave;
}

/// Keeps the part within `radius` of the z axis.
bool clip_round(const Vector3d& origin, const Vector3d& direction, double radius, Inside* inside) {
  const double a = direction.head<2>().squaredNorm();
  const double c = origin.head<2>().squaredNorm() - radius * radius;
  if (a < 1e-18) return c <= 0;
  const double b = origin.head<2>().dot(direction.head<2>());
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return false;
  const double root = std::sqrt(discriminant);
  const double enter = (-b - root) / a;
  if (enter > inside->enter) {
    inside->enter = enter;
    const Vector3d at = origin + enter * direction;
    inside->normal = Vector3d(at.x(), at.y(), 0) / radius;
  }
  inside->leave = std::min(inside->leave, (-b + root) / a);
  return inside->enter <= inside->leave;
}

std::optional<Crossing> crossing(const Vector3d& direction, double enter, const Vector3d& normal) {
  if (enter <= 0) return std::nullopt;
  return Crossing{enter, std::min(1.0, std::abs(direction.dot(normal)))};
}

std::optional<Crossing> cross_box(const Vector3d& origin, const Vector3d& direction, const Vector3d& half) {
  Inside inside;
  for (int axis = 0; axis < 3; ++axis) {
    if (!clip_slab(origin, direction, axis, half[axis], &inside)) return std::nullopt;
  }
  return crossing(direction, inside.enter, inside.normal);
}

std::optional<Crossing> cross_cylinder(const Vector3d& origin, const Vector3d& direction,
                                       const Vector3d& half) {
  Inside inside;
  if (!clip_slab(origin, direction, 2, half.z(), &inside) ||
      !clip_round(origin, direction, half.x(), &inside)) {
    return std::nullopt;
  }
  return crossing(direction, inside.enter, inside.normal);
}

std::optional<Crossing> cross_ellipsoid(const Vector3d& origin, const Vector3d& direction,
                                        const Vector3d& half) {
  // In the space where the ellipsoid is the unit sphere; the ray's parameter stays the range.
  const Vector3d o = origin.cwiseQuotient(half), d = direction.cwiseQuotient(half);
  const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - 1.0;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const double enter = (-b - std::sqrt(discriminant)) / a;
  const Vector3d normal = (o + enter * d).cwiseQuotient(half).normalized();
  return crossing(direction, enter, normal);
}

std::optional<Crossing> cross_capsule(const Vector3d& origin, const Vector3d& direction,
                                      const Vector3d& half) {
  std::optional<Crossing> nearest = cross_cylinder(origin, direction, half);
  for (const double end : {-half.z(), half.z()}) {
    const auto ball = cross_ellipsoid(origin - Vector3d(0, 0, end), direction, Vector3d::Constant(half.x()));
    if (ball && (!nearest || ball->range_m < nearest->range_m)) nearest = ball;
  }
  return nearest;
}

std::optional<Crossing> cross_disc(const Vector3d& origin, const Vector3d& direction, double radius) {
  if (std::abs(direction.z()) < 1e-9) return std::nullopt;
  const double range_m = -origin.z() / direction.z();
  if ((origin + range_m * direction).head<2>().squaredNorm() > radius * radius) return std::nullopt;
  return crossing(direction, range_m, Vector3d::UnitZ());
}

Shape along_axis(ShapeKind kind, const Vector3d& from, const Vector3d& to, double radius_m,
                 const Surface& surface) {
  const Vector3d axis = to - from;
  const Eigen::Matrix3d R = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
  return {kind, {radius_m, radius_m, axis.norm() / 2}, (from + to) / 2, R, surface};
}

}  // namespace

std::optional<Crossing> Shape::cross(const Ray& ray) const {
  const Vector3d origin = R_parent_shape.transpose() * (ray.origin - center);
  const Vector3d direction = R_parent_shape.transpose() * ray.direction;
  switch (kind) {
    case ShapeKind::kBox:
      return cross_box(origin, direction, half_size_m);
    case ShapeKind::kCylinder:
      return cross_cylinder(origin, direction, half_size_m);
    case ShapeKind::kCapsule:
      return cross_capsule(origin, direction, half_size_m);
    case ShapeKind::kEllipsoid:
      return cross_ellipsoid(origin, direction, half_size_m);
    case ShapeKind::kDisc:
      return cross_disc(origin, direction, half_size_m.x());
  }
  return std::nullopt;
}

Eigen::AlignedBox3d Shape::bounds() const {
  Vector3d half = half_size_m;
  if (kind == ShapeKind::kCapsule) half.z() += half.x();
  const Vector3d extent = R_parent_shape.cwiseAbs() * half;
  return {center - extent, center + extent};
}

Shape make_box(const Eigen::Isometry3d& T_parent_box, const Vector3d& size_m, const Surface& surface) {
  return {ShapeKind::kBox, size_m / 2, T_parent_box.translation(), T_parent_box.linear(), surface};
}

Shape make_cylinder(const Eigen::Isometry3d& T_parent_cylinder, double radius_m, double height_m,
                    const Surface& surface) {
  return {ShapeKind::kCylinder,
          {radius_m, radius_m, height_m / 2},
          T_parent_cylinder.translation(),
          T_parent_cylinder.linear(),
          surface};
}

Shape make_cylinder_between(const Vector3d& from, const Vector3d& to, double radius_m,
                            const Surface& surface) {
  return along_axis(ShapeKind::kCylinder, from, to, radius_m, surface);
}

Shape make_capsule(const Vector3d& from, const Vector3d& to, double radius_m, const Surface& surface) {
  return along_axis(ShapeKind::kCapsule, from, to, radius_m, surface);
}

Shape make_ellipsoid(const Vector3d& center, const Vector3d& semi_axes_m, const Surface& surface) {
  return {ShapeKind::kEllipsoid, semi_axes_m, center, Eigen::Matrix3d::Identity(), surface};
}

Shape make_disc(const Vector3d& center, const Vector3d& normal, double radius_m, const Surface& surface) {
  const Eigen::Matrix3d R = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), normal).toRotationMatrix();
  return {ShapeKind::kDisc, {radius_m, radius_m, 0}, center, R, surface};
}

Eigen::Isometry3d pose_at(double x, double y, double z, double yaw_rad) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Vector3d(x, y, z);
  T.linear() = Eigen::AngleAxisd(yaw_rad, Vector3d::UnitZ()).toRotationMatrix();
  return T;
}

}  // namespace stillmap::simulation
