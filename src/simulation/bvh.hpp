#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "simulation/shape.hpp"

namespace stillmap::simulation {

/// A tree of bounding boxes over numbered things.
class Bvh {
 public:
  explicit Bvh(const std::vector<Eigen::AlignedBox3d>& bounds);

  /// Calls visit(item, limit_m) for the items whose box the ray meets nearer than limit_m, nearer boxes
  /// first; visit returns the new limit.
  template <class Visit>
  void walk(const Ray& ray, double limit_m, Visit&& visit) const;

 private:
  struct Node {
    std::array<double, 6> box;  ///< min x, y, z, max x, y, z
    std::uint32_t first;        ///< leaf: first item; else: the left child, the right one follows it
    std::uint32_t count;        ///< items of a leaf; 0 = inner node
  };

  void split(std::uint32_t node, std::uint32_t first, std::uint32_t count,
             const std::vector<Eigen::AlignedBox3d>& bounds);
  static double enter_m(const Node& node, const Ray& ray, const Eigen::Vector3d& inverse, double limit_m);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
};

/// Range at which the ray enters the box (0 = starts inside); limit_m where it misses it or is too far.
inline double Bvh::enter_m(const Node& node, const Ray& ray, const Eigen::Vector3d& inverse, double limit_m) {
  double enter = 0, leave = limit_m;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const double a = (node.box[axis] - ray.origin[i]) * inverse[i];
    const double b = (node.box[axis + 3] - ray.origin[i]) * inverse[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? enter : limit_m;
}

template <class Visit>
void Bvh::walk(const Ray& ray, double limit_m, Visit&& visit) const {
  if (nodes_.empty()) return;
  const Eigen::Vector3d inverse = ray.direction.cwiseInverse();
  struct Pending {
    std::uint32_t node;
    double enter_m;
  };
  std::array<Pending, 64> stack;  // splitting at the median keeps the depth below 32
  std::size_t depth = 0;
  stack[depth++] = {0, enter_m(nodes_[0], ray, inverse, limit_m)};
  while (depth > 0) {
    const Pending pending = stack[--depth];
    if (pending.enter_m >= limit_m) continue;
    const Node& node = nodes_[pending.node];
    for (std::uint32_t i = 0; i < node.count; ++i) limit_m = visit(items_[node.first + i], limit_m);
    if (node.count > 0) continue;
    Pending near{node.first, enter_m(nodes_[node.first], ray, inverse, limit_m)};
    Pending far{node.first + 1, enter_m(nodes_[node.first + 1], ray, inverse, limit_m)};
    if (far.enter_m < near.enter_m) std::swap(near, far);
    if (far.enter_m < limit_m) stack[depth++] = far;
    if (near.enter_m < limit_m) stack[depth++] = near;
  }
}

}  // namespace stillmap::simulation
