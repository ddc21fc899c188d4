#include "baselines/support_map.hpp"

#include <algorithm>

#include "baselines/removal_method.hpp"

namespace stillmap {

void SupportMap::add(const Frame& frame) {
  if (!enabled()) return;
  hit_.clear();
  for (const Eigen::Vector3f& point : frame.scan.points) {
    if (!is_return(point)) continue;
    const VoxelKey key = map_.key_of(frame.T_map_sensor * point.cast<double>());
    const std::uint64_t block = map_.find_or_create_block(block_key(key));
    hit_.push_back(block * kBlockVolume + static_cast<std::uint64_t>(place_in_block(key)));
  }
  std::sort(hit_.begin(), hit_.end());
  hit_.erase(std::unique(hit_.begin(), hit_.end()), hit_.end());
  for (const std::uint64_t index : hit_) {
    bool created = false;
    Voxel& voxel = map_.block(static_cast<std::uint32_t>(index / kBlockVolume))
                       .find_or_create(static_cast<int>(index % kBlockVolume), created);
    if (voxel.hits < 0xFF) ++voxel.hits;
  }
}

}  // namespace stillmap
