#include "submaps.hpp"

#include <algorithm>

namespace stillmap {

void Submaps::add(const StampedPose& pose, bool of_first_sensor, const ScanView& view,
                  const std::vector<VoxelKey>& born, VoxelReader map) {
  if (of_first_sensor) go_to(pose);
  const bool none = submaps_.empty() || !submaps_.back().anchored;
  if (none || way_m_ >= length_m_) begin(pose, map);
  Submap& present = submaps_.back();
  if (present.views.empty() || way_m_ - view_way_m_ >= length_m_ / kViewsInSubmap) {
    present.views.push_back(view);
    view_way_m_ = way_m_;
  }
  for (const VoxelKey& key : born) present.voxels.push_back({key, Voxel()});
}

void Submaps::go_to(const StampedPose& pose) {
  if (!trajectory_.poses().empty())
    way_m_ +=
        (pose.T_map_sensor.translation() - trajectory_.poses().back().T_map_sensor.translation()).norm();
  trajectory_.add(pose);
}

void Submaps::begin(const StampedPose& pose, VoxelReader& map) {
  // The one before the last has seen the last one's scans, too: its evidence is complete.
  if (submaps_.size() >= 2) {
    Submap& complete = submaps_[submaps_.size() - 2];
    if (!complete.closed) refresh(complete, map);
    complete.closed = true;
    complete.voxels.shrink_to_fit();
  }
  submaps_.emplace_back();
  submaps_.back().stamp_ns = pose.stamp_ns;
  way_m_ = view_way_m_ = 0;
}

void Submaps::refresh(Submap& submap, VoxelReader& map) {
  std::vector<PlacedVoxel> known;
  for (const PlacedVoxel& placed : submap.voxels)
    if (const std::optional<Voxel> voxel = map.find(placed.key)) known.push_back({placed.key, *voxel});
  submap.scan = map.scan();
  submap.voxels = std::move(known);
}

void Submaps::add_unanchored(std::vector<PlacedVoxel> voxels, std::uint32_t scan) {
  Submap fixed;
  fixed.scan = scan;
  fixed.anchored = false;
  fixed.closed = true;
  fixed.voxels = std::move(voxels);
  submaps_.insert(submaps_.begin(), std::move(fixed));
}

}  // namespace stillmap
