#include <algorithm>
#include <stdexcept>

#include "mapper_state.hpp"

namespace stillmap {
namespace {

void require_box(const Eigen::AlignedBox3d& box_map_m) {
  if (box_map_m.min().allFinite() && box_map_m.max().allFinite() && !box_map_m.isEmpty()) return;
  throw std::invalid_argument(
      "the box is empty or not finite; each coordinate of min must be below that of max");
}

/// Where a voxel's returns lie.
Eigen::Vector3d place_of(const BlockKey& block, int place, const Voxel& voxel, double voxel_size_m) {
  return (voxel_key(block, place).cast<double>() + voxel.surface_offset().cast<double>()) * voxel_size_m;
}

Eigen::AlignedBox3d box_of(const BlockKey& block, double block_size_m) {
  const Eigen::Vector3d low = block.cast<double>() * block_size_m;
  return {low, low + Eigen::Vector3d::Constant(block_size_m)};
}

}  // namespace

std::size_t Mapper::clear_box(const Eigen::AlignedBox3d& box_map_m) {
  return up_to_date().edit_box(box_map_m, [](Voxel&) { return false; });
}

std::size_t Mapper::relabel_box(const Eigen::AlignedBox3d& box_map_m, Label label) {
  const Parameters& p = state_->parameters;
  if (label == Label::kInvalid)
    throw std::invalid_argument("a voxel is static, dynamic or uncertain; give one of these labels");
  const double log_odds = label == Label::kStatic    ? p.log_odds_max
                          : label == Label::kDynamic ? p.log_odds_min
                                                     : 0.0;
  return up_to_date().edit_box(box_map_m, [=](Voxel& voxel) {
    voxel.set_log_odds(static_cast<float>(log_odds));
    return true;
  });
}

std::size_t Mapper::State::edit_box(const Eigen::AlignedBox3d& box_map_m,
                                    const std::function<bool(Voxel&)>& edit) {
  require_box(box_map_m);
  std::size_t edited = 0;
  ++revision;
  rolling.edit(box_map_m, scan_count, [&](BlockContents& block) {
    if (!box_of(block.key, map.block_size_m()).intersects(box_map_m)) return false;
    const BlockContents before = block;
    block.voxels.clear();
    const std::size_t edited_before = edited;
    for_each_voxel(before, [&](int place, Voxel voxel) {
      const bool inside = box_map_m.contains(place_of(before.key, place, voxel, map.voxel_size_m()));
      edited += inside;
      if (!inside || edit(voxel))
        block.voxels.push_back(voxel);
      else
        block.occupied[place >> 6] &= ~(std::uint64_t{1} << (place & 63));
    });
    return edited > edited_before;
  });
  // What is kept to follow corrections follows the repair.
  for (Submap& submap : submaps.all()) {
    const auto forgotten = [&](PlacedVoxel& placed) {
      const Eigen::Vector3d place =
          place_of(block_key(placed.key), place_in_block(placed.key), placed.voxel, map.voxel_size_m());
      return submap.closed && box_map_m.contains(place) && !edit(placed.voxel);
    };
    submap.voxels.erase(std::remove_if(submap.voxels.begin(), submap.voxels.end(), forgotten),
                        submap.voxels.end());
  }
  return edited;
}

}  // namespace stillmap
