#include "simulation/bvh.hpp"

#include <numeric>

namespace stillmap::simulation {

Bvh::Bvh(const std::vector<Eigen::AlignedBox3d>& bounds) : items_(bounds.size()) {
  if (bounds.empty()) return;
  std::iota(items_.begin(), items_.end(), 0U);
  nodes_.reserve(bounds.size());
  nodes_.push_back({});
  split(0, 0, static_cast<std::uint32_t>(items_.size()), bounds);
}

void Bvh::split(std::uint32_t node, std::uint32_t first, std::uint32_t count,
                const std::vector<Eigen::AlignedBox3d>& bounds) {
  Eigen::AlignedBox3d all, centers;
  for (std::uint32_t i = first; i < first + count; ++i) {
    all.extend(bounds[items_[i]]);
    centers.extend(bounds[items_[i]].center());
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    nodes_[node].box[axis] = all.min()[static_cast<Eigen::Index>(axis)];
    nodes_[node].box[axis + 3] = all.max()[static_cast<Eigen::Index>(axis)];
  }
  constexpr std::uint32_t kLeafSize = 3;
  if (count <= kLeafSize) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  Eigen::Index axis = 0;
  centers.sizes().maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  const auto begin = items_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    const double at_a = bounds[a].center()[axis], at_b = bounds[b].center()[axis];
    return at_a != at_b ? at_a < at_b : a < b;
  });
  const auto left = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = left;
  nodes_[node].count = 0;
  nodes_.push_back({});
  nodes_.push_back({});
  split(left, first, half, bounds);
  split(left + 1, first + half, count - half, bounds);
}

}  // namespace stillmap::simulation
