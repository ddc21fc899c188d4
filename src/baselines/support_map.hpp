#pragma once

#include <vector>

#include "core/structure_gates.hpp"
#include "io/sequence.hpp"

namespace stillmap {

/// Counts the scans that hit each voxel, for the structure gates of a baseline's preset `paper`.
class SupportMap {
 public:
  SupportMap(double voxel_size_m, const GateSettings& gates) : map_(voxel_size_m), gates_(gates) {}

  void add(const Frame& frame);
  /// Looks at the scans added so far; valid until the next add().
  StructureGates gates() const { return StructureGates(map_, gates_); }
  VoxelKey key_of(const Eigen::Vector3d& point_map_m) const { return map_.key_of(point_map_m); }
  bool enabled() const { return gates_.any(); }

 private:
  VoxelMap map_;
  GateSettings gates_;
  std::vector<std::uint64_t> hit_;  ///< voxels of the present scan: block index, then place
};

}  // namespace stillmap
