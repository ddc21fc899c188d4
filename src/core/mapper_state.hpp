#pragma once

#include "cell_mask.hpp"
#include "clusters.hpp"
#include "ground.hpp"
#include "scan_history.hpp"
#include "stillmap/decision.hpp"
#include "stillmap/mapper.hpp"
#include "stillmap/projection.hpp"
#include "stillmap/sensor_geometry.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {

/// Where a row of the scan lies in the map.
struct VoxelRef {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::uint32_t block = kNone;
  std::uint32_t place = 0;
  bool exists() const { return block != kNone; }
};

/// A voxel that this scan showed first.
struct NewVoxel {
  VoxelRef voxel;
  std::uint32_t row;  ///< of the scan: the return that made it
};

/// All that a Mapper holds. The steps of process() are its functions, each in the file named beside it.
struct Mapper::State {
  explicit State(const Parameters& parameters);

  Parameters parameters;
  std::vector<LevelModel> models;
  Recursion recursion;
  Decision decision;
  GeometryEstimator geometry;
  VoxelMap map;
  ScanHistory history;
  StageListener* listener = nullptr;
  std::uint32_t scan_count = 0;
  std::int64_t stamp_ns = 0;

  // Of the present scan; kept to spare their allocation.
  ProjectedScan projected;
  std::vector<VoxelRef> voxel_of_row;
  std::vector<NewVoxel> new_voxels;
  std::vector<std::uint32_t> hit_blocks;
  std::vector<std::uint8_t> row_flags;
  Ground ground;
  Clusters clusters;
  SensorGeometry beams;
  ScanLabels labels;

  ScanView view_of(const Scan& scan, const Eigen::Isometry3d& T_map_sensor);     // mapper.cpp
  void insert(const Scan& scan, const Eigen::Isometry3d& T_map_sensor);          // insertion.cpp
  void find_standing_surface();                                                  // standing.cpp
  CellMask near_standing_surface(const BlockKey& key) const;                     // standing.cpp
  void apply_evidence(const ScanView& view);                                     // map_evidence.cpp
  void replay_history(const Scan& scan, const Eigen::Isometry3d& T_map_sensor);  // replay.cpp
  void decide();                                                                 // mapper.cpp
  void resolve_objects(const Scan& scan, const Eigen::Isometry3d& T_map_sensor, const ScanView& view);  // objects.cpp
  void ended(Stage stage) {
    if (listener != nullptr) listener->stage_ended(stage);
  }
};

}  // namespace stillmap
