#pragma once

#include <tsl/robin_map.h>

#include <functional>
#include <optional>

#include "beam_share.hpp"
#include "block_projection.hpp"
#include "calibration.hpp"
#include "coarse_image.hpp"
#include "map_points.hpp"
#include "on_all_threads.hpp"
#include "present_scan.hpp"
#include "probability_table.hpp"
#include "rolling_map.hpp"
#include "scan_alignment.hpp"
#include "scan_history.hpp"
#include "stillmap/decision.hpp"
#include "stillmap/mapper.hpp"
#include "stillmap/sensor_geometry.hpp"
#include "stillmap/voxel_map.hpp"
#include "structure_gates.hpp"
#include "submaps.hpp"
#include "support_table.hpp"

namespace stillmap {

/// What is kept of each LiDAR.
struct SensorState {
  GeometryEstimator geometry;
  ScanHistory history;
  SensorGeometry beams{};  ///< as its last scan left them
  std::uint32_t scans = 0;
  PoseJumps jumps{};
};

/// All that a Mapper holds: its map, and of the present scan what the base holds. The steps of process() are
/// its functions, each in the file named above it.
struct Mapper::State : PresentScan {
  explicit State(const Parameters& parameters);

  Parameters parameters;
  std::vector<LevelModel> models;
  Recursion recursion;
  Decision decision;
  ProbabilityTable p_static;
  Calibration calibration;
  SupportTables support_tables;
  std::vector<SensorState> sensors;  ///< by Scan::sensor
  VoxelMap map;                      ///< what a scan can touch
  RollingMap rolling;                ///< all of it
  Submaps submaps;
  FusedEvidence own_hit;
  WorkerArena arena;
  bool every_voxel_is_judged;  ///< or only the nearest of each pixel
  Voxel untold;                ///< a new voxel that no earlier scan said anything about
  StageListener* listener = nullptr;
  std::uint32_t scan_count = 0;
  std::int64_t stamp_ns = 0;
  std::uint64_t revision = 0;
  float settling_step = 0;  ///< of log-odds, in the present scan

  std::optional<LabelledScan> awaits_upkeep;  ///< the present scan, until upkeep() is through with it

  // see.cpp
  SensorState& sensor(int index);
  /// The scan as its sensor saw it, from where it was.
  LabelledScan& see(const Scan& scan, const Eigen::Isometry3d& T_map_sensor);
  std::vector<RangeImage> range_images() const;

  // mapper.cpp
  /// Memories are told in scans of one LiDAR; the map counts the scans of all.
  std::uint32_t scans_of_all(std::uint32_t scans_of_one) const {
    return scans_of_one * static_cast<std::uint32_t>(sensors.size());
  }
  void go_on_to(std::int64_t next_stamp_ns);
  void upkeep();
  /// No return, and no voxel that a return says something about, lies in a block whose corner is farther.
  double reach_m() const { return parameters.max_range_m + 2 * map.block_size_m(); }
  void ended(Stage stage) {
    if (listener != nullptr) listener->stage_ended(stage);
  }

  // scan_alignment.cpp
  /// The pose of the present scan, without what it jumped.
  Eigen::Isometry3d aligned(const Eigen::Isometry3d& T_map_sensor, PoseJumps& jumps) const;
  /// Where the map has a scan that was seen before.
  Eigen::Isometry3d realigned(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) const;

  // insertion.cpp
  void insert();
  void find_hit_blocks();
  std::uint32_t hit_of_block(std::uint64_t packed_key);
  bool is_hit(std::uint32_t block) const {
    return block < last_hits.size() && last_hits[block].scan == scan_count;
  }
  void sort_rows_by_block();
  void insert_rows(HitBlock& hit);
  /// Index in the map of the block that a judged row lies in.
  std::uint32_t block_of(std::uint32_t row) const {
    return static_cast<std::uint32_t>(map.find_block(unpacked(located.block[row])));
  }
  /// Calls work(hit) for each block that this scan hit, on all threads; voxels are fetched ahead.
  template <class Work>
  void for_each_hit_block(Work&& work) {
    constexpr std::size_t kAtLeast = 32, kFarAhead = 8, kAhead = 3;
    for_pieces(hit_blocks.size(), kAtLeast, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        if (i + kFarAhead < last) hit_blocks[i + kFarAhead].block->prefetch();
        if (i + kAhead < last) hit_blocks[i + kAhead].block->prefetch_voxels();
        work(hit_blocks[i]);
      }
    });
  }

  // map_evidence.cpp: every voxel compares its own range with I_O
  void apply_evidence_to_hits(const ScanView& view);
  void apply_evidence_to_others(const ScanView& view);
  void support_returned(VoxelBlock& block, const PlaceMask& places) const;
  void judge_hit_block(const ScanView& view, VoxelBlock& block);
  void judge_tile(const ScanView& view, const CoarseView& coarse, const BlockTile& tile);
  void judge_block(const ScanView& view, VoxelBlock& block, BlockProjection::Asked asked);
  void judge(const ScanView& view, VoxelBlock& block, const BlockProjection& seen);
  Eigen::Vector3f corner_of(const BlockKey& key, const ScanView& view) const;
  void support(Voxel& voxel, const SupportTable& table) const;
  /// What moved in and stays gains, however strong its support, settling_step a scan as long as L < 0.
  bool is_settling(const Voxel& voxel) const;
  void let_settle(Voxel& voxel) const;
  float conflict_factor(bool is_porous, bool beside_surface) const;
  BeamShare beam_share(const SensorGeometry& of_beams) const;

  // nearest_voxel_evidence.cpp: the literal reading, only the nearest voxel of a pixel is judged
  void apply_evidence_to_nearest(const ScanView& view);

  // replay.cpp
  void replay_history(const Eigen::Isometry3d& T_map_sensor);
  void replay_history(const Eigen::Isometry3d& T_map_sensor, std::size_t first, std::size_t last);
  float replay_conflict_factor(const NewVoxel& voxel) const;

  // neighbourhood.cpp
  void find_known_surface(VoxelBlock& block) const;
  struct KnownSurface {
    CellMask standing, porous;
  };
  KnownSurface near_known_surface(const BlockKey& key, CellMask asked) const;
  CellMask near_porous(const BlockKey& key, CellMask asked) const;
  /// Of the cells that are asked for, those that `cells_of` has set in the block or its neighbours, or right
  /// beside.
  template <class CellsOf>
  CellMask near(const BlockKey& key, CellMask asked, CellsOf&& cells_of) const {
    std::array<CellMask, 27> around{};
    CellMask any = 0;
    for_each_around(key, asked, [&](int i, const VoxelBlock& block) { any |= around[i] = cells_of(block); });
    return any != 0 ? grown(around) & asked : 0;
  }
  /// Calls visit(i, block) for the block and its neighbours, of 3 x 3 x 3, that touch a cell that is asked
  /// for.
  template <class Visitor>
  void for_each_around(const BlockKey& key, CellMask asked, Visitor&& visit) const {
    for (int i = 0; i < 27; ++i) {
      const BlockKey step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      if ((asked & facing(step.x(), step.y(), step.z())) == 0) continue;
      const std::int64_t index = map.find_block(key + step);
      if (index >= 0) visit(i, map.block(static_cast<std::uint32_t>(index)));
    }
  }

  // moving_memory.cpp: where something moved in the last scans
  bool saw_mover(std::uint32_t row) const;
  void remember_moving();
  void spread_moving();
  void doubt_beside_movers();
  std::vector<std::uint32_t> moving_blocks;  ///< where something moved in the last scans
  tsl::robin_map<std::uint64_t, CellMask, BlockKeyHash> moving_around;  ///< by packed key: cells beside them

  // explain.cpp
  std::vector<PlaceEvidence> evidence_about(const Eigen::Vector3d& place_map_m, const ScanView& view) const;

  // map_exchange.cpp
  void require_importable(const MapContents& contents) const;

  // map_repair.cpp: edits every voxel in the box; one for which `edit` says false is forgotten
  std::size_t edit_box(const Eigen::AlignedBox3d& box_map_m, const std::function<bool(Voxel&)>& edit);

  // loop_closure.cpp: the map as submaps that a corrected trajectory moves; only with submap_length_m
  using StandingCells = tsl::robin_map<std::uint64_t, CellMask, BlockKeyHash>;  ///< by packed block key
  void remember_for_corrections(const ScanView& view, const Eigen::Isometry3d& T_map_sensor);
  void require_submaps() const;
  TrajectoryCorrection correct(const PastCorrection& correction);
  void move_submaps(const PastCorrection& correction);
  void place_submaps();
  void place(const Submap& submap);
  StandingCells standing_cells(const Submap& submap) const;
  void judge_again(const ScanView& view, const CoarseView& coarse, VoxelBlock& block,
                   const StandingCells& standing);

  // labelling.cpp
  void decide(const ScanView& view);
  void decide_rows(const HitBlock& hit, const ScanView& view);
  /// Why a voxel is not static.
  Reason reason_of(const VoxelBlock& block, const Voxel& voxel, int place, Label label,
                   const ScanView& view) const;
  void calibrate();

  // relabelling.cpp
  bool overrules(const Voxel& voxel, Label label_of_map, Label label_online) const;
  /// `gates` may be nullptr.
  void settle_by_map(ScanLabels& settled, std::size_t row, const VoxelKey& key, const Voxel& voxel,
                     const StructureGates* gates) const;
  void settle_objects(ScanLabels& settled) const;

  // objects.cpp, patches.cpp, vanished.cpp, specks.cpp, arrivals.cpp
  /// By the shape of the scan alone, so that it may run beside what the map says of the rows.
  void find_objects(const Eigen::Isometry3d& T_map_sensor);
  void resolve_objects(const Scan& scan, const Eigen::Isometry3d& T_map_sensor, const ScanView& view);
  void settle_ground();
  void find_followed();
  void count_votes();
  void find_runs(std::size_t first, std::size_t last, std::vector<PatchRun>& found) const;
  /// Calls work(run) for each run, on all threads.
  template <class Work>
  void for_each_run(Work&& work) {
    for_each_index(runs.size(), [&](std::size_t piece) {
      for (PatchRun& run : runs[piece]) work(run);
    });
  }
  void test_vanished(const Scan& scan, const Eigen::Isometry3d& T_map_sensor, const ScanView& view);
  /// Of each point: whether what hid its place from an earlier scan is gone.
  std::vector<std::uint8_t> replaced_vanished(MapPoints& points, const ScanHistory& history,
                                              const ScanView& view) const;
  void decide_by_vote();
  void settle(std::size_t row, Reason reason);
  void defer_specks();
  void remember_arrivals();
  bool is_judged(std::size_t row) const { return located.block[row] != LocatedRows::kNowhere; }
  bool is_established(std::size_t row) const {
    return (labels.label[row] == Label::kStatic) & (on_old_surface[row] != 0);
  }
  bool is_just_static(std::size_t row) const {
    return (labels.label[row] == Label::kStatic) & (on_old_surface[row] == 0);
  }

  // insides.cpp
  static constexpr int kNoVehicle = -1;
  void take_insides_along();
  void find_vehicles();
  bool in_a_vehicle(std::size_t row) const;

  // feet.cpp
  void take_feet_along();
  int pixel_of(std::uint32_t row) const;  ///< of clusters
  void note_mover(std::uint32_t row);
  bool belongs_to_mover(std::int32_t row) const;
};

}  // namespace stillmap
