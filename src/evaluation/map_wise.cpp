#include "evaluation/map_wise.hpp"

namespace stillmap {

BlockKey MapWiseCount::cell_of(const Eigen::Vector3d& point) const {
  return (point / reach_m_).array().floor().cast<int>();
}

void MapWiseCount::add_removed(const Eigen::Vector3d& point_map_m, bool truth_is_dynamic) {
  // In every cell from which it can be reached: there are few removed points and many others.
  const auto index = static_cast<std::uint32_t>(removed_.size());
  removed_.push_back({point_map_m, truth_is_dynamic, false});
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        near_[packed(cell_of(point_map_m) + BlockKey(dx, dy, dz))].push_back(index);
}

void MapWiseCount::add_to_map(const Eigen::Vector3d& point_map_m) {
  const auto near = near_.find(packed(cell_of(point_map_m)));
  if (near == near_.end()) return;
  for (const std::uint32_t index : near->second)
    if ((removed_[index].point - point_map_m).squaredNorm() <= reach_m_ * reach_m_)
      removed_[index].retained = true;
}

Confusion MapWiseCount::counts() const {
  Confusion counts = counts_;
  for (const Removed& point : removed_)
    counts.add(point.dynamic, point.retained ? Label::kStatic : Label::kDynamic);
  return counts;
}

}  // namespace stillmap
