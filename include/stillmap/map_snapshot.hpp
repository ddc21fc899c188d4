#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "stillmap/types.hpp"

namespace stillmap {

/// One voxel of a snapshot.
struct SnapshotVoxel {
  Eigen::Vector3f center;  ///< map frame, metres
  float log_odds;          ///< of being static, eq. (1)
  Label label;             ///< eq. (9)
};

/// An immutable copy of the map; cheap to share between a publisher, an exporter and a test.
struct MapSnapshot {
  std::int64_t stamp_ns = 0;  ///< of the newest scan in it
  double voxel_size_m = 0;
  std::vector<SnapshotVoxel> voxels;  ///< tile by tile; in a block by place
};
using MapSnapshotPtr = std::shared_ptr<const MapSnapshot>;

}  // namespace stillmap
