#pragma once

#include <Eigen/Core>
#include <vector>

#include "stillmap/decision.hpp"
#include "stillmap/map_contents.hpp"

namespace stillmap {

struct DiffOptions {
  int tolerance_voxels = 2;       ///< surface that the other map has so near is the same
  double mapped_within_m = 1.6;   ///< the other map must have something so near, or it was not there at all
  double least_height_m = 0.3;    ///< of a change; lower ones are ground that something hid in one session
  std::size_t least_voxels = 10;  ///< of a change; smaller ones are noise of the surface
};

/// Static surface that one of two maps has and the other has not.
struct Change {
  std::vector<VoxelKey> voxels;
  Eigen::AlignedBox3d extent_m;
};

struct MapDiff {
  double voxel_size_m = 0;
  std::vector<Change> appeared, gone;           ///< the largest first
  std::vector<VoxelKey> same;                   ///< of the second map
  std::size_t only_first = 0, only_second = 0;  ///< static voxels where the other map has nothing around
};

/// What appeared and what went between two maps of one frame. Throws std::invalid_argument when the voxel
/// sizes differ.
MapDiff diff(const MapContents& first, const MapContents& second, const Decision& decision,
             const DiffOptions& options);

}  // namespace stillmap
