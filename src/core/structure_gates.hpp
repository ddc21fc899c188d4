#pragma once

#include <tsl/robin_map.h>

#include <cstdint>

#include "stillmap/parameters.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// The experiment's structure gates, section 2.1. Points are counted after the down-sampling of table 1: one
/// for each scan that hit a voxel. 0 switches a gate off.
struct GateSettings {
  int voxel_support = 0;
  int neighbourhood_support = 0;
  int grid_support = 0;
  double height_above_ground_m = 0.0;

  bool any() const {
    return voxel_support > 0 || neighbourhood_support > 0 || grid_support > 0 || height_above_ground_m > 0;
  }
};
GateSettings gate_settings(const Parameters& parameters);

/// Protects structure: a dynamic verdict stands only on a voxel that few scans hit, or that has few points in
/// its 3x3x3 neighbourhood and in its vertical column; and only above the local ground. z of the map is up.
class StructureGates {
 public:
  /// Looks at the map as it is now, which must outlive this object unchanged.
  StructureGates(const VoxelMap& map, const GateSettings& settings);

  bool dynamic_may_stand(const VoxelKey& key) const;

 private:
  bool few_points(const VoxelKey& key) const;
  int neighbourhood_support(const VoxelKey& key) const;
  int column_support(const VoxelKey& key) const;
  double height_above_ground_m(const VoxelKey& key) const;
  void find_ground();

  const VoxelMap& map_;
  GateSettings settings_;
  int block_z_min_ = 0, block_z_max_ = -1;  ///< of the blocks of the map

  /// z of the lowest voxel in each upright cell of 1 m, by packed x and y.
  tsl::robin_map<std::uint64_t, float, BlockKeyHash> lowest_m_;
};

}  // namespace stillmap
