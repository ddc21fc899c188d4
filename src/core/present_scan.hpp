#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "clusters.hpp"
#include "ground.hpp"
#include "located_rows.hpp"
#include "object_votes.hpp"
#include "outline.hpp"
#include "scan_view.hpp"
#include "stillmap/projection.hpp"
#include "stillmap/sensor_geometry.hpp"
#include "stillmap/types.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// A voxel that the present scan made.
struct NewVoxel {
  std::uint32_t row;    ///< of the scan, whose return made it
  std::uint32_t block;  ///< its index in the map
  std::uint16_t place;  ///< in the block
  std::uint16_t rank;   ///< among the block's stored ones, in the present scan
};

/// The last scan that hit a block, and the block's number among all that it hit.
struct LastHit {
  std::uint32_t scan = 0, hit = 0;
};

/// A block that this scan hit. Its rows are rows_by_block[first_row + 0 .. row_count - 1]; the
/// voxels that it made are made_by_block[first_row + 0 .. new_count - 1].
struct HitBlock {
  VoxelBlock* block;
  std::uint32_t index;  ///< of the block in the map
  std::uint32_t first_row = 0, row_count = 0, new_count = 0;
};

/// Rows of the scan that follow each other in one block: HitBlock number `hit`, first .. last - 1.
struct BlockRun {
  std::uint32_t hit, first, last;
};

/// A scan that has its labels.
struct LabelledScan {
  ScanView view;
  Eigen::Isometry3d T_map_sensor;
};

/// What the steps of a Mapper say of the present scan, kept to spare its allocation. Vectors by row have the
/// scan's size.
struct PresentScan {
  SensorGeometry beams;
  ProjectedScan projected;
  LocatedRows located;
  std::vector<HitBlock> hit_blocks;
  std::vector<LastHit> last_hits;  ///< by index of the block in the map
  std::vector<BlockRun> block_runs;
  std::vector<std::uint32_t> rows_by_block;   ///< rows of the scan
  std::vector<std::uint16_t> ranks_by_block;  ///< of their voxels among the block's stored ones
  std::vector<NewVoxel> made_by_block, new_voxels;
  std::vector<std::uint8_t> on_old_surface;  ///< by judged row: its voxel has been there for a while
  std::vector<std::uint8_t> on_porous;  ///< by judged row: its voxel was hit again after it was seen through
  std::vector<const BlockTile*> near_tiles;  ///< with all that the scan may say something about, and more
  ScanLabels labels;
  UprightRows upright;
  Ground ground;
  std::vector<float> height_above_ground_m;  ///< by row
  std::vector<std::uint32_t> standing_rows;  ///< judged, and not on the ground
  std::vector<std::uint32_t> moving_rows;    ///< dynamic by the votes, and what goes with them
  std::vector<std::uint32_t> low_rows;       ///< at the height of feet
  std::vector<int> low_pixels;               ///< of clusters: where they lie
  Clusters clusters, moving_pieces;
  std::vector<std::uint8_t> followed;       ///< by row: right beside what moved in the last scans
  std::vector<std::vector<PatchRun>> runs;  ///< of standing_rows with a cluster, by piece of them
  std::vector<Votes> object_votes, patch_votes;
  std::vector<std::uint32_t> patch_of_row;  ///< where a row has a cluster
  std::vector<Outline> vehicles;            ///< that move
  std::vector<int> vehicle_of_object, rows_inside;
  std::vector<std::uint8_t> moves_above_pixel;  ///< of clusters: any_above() may find something that moves
};

}  // namespace stillmap
