#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "stillmap/explanation.hpp"
#include "stillmap/map_contents.hpp"
#include "stillmap/map_snapshot.hpp"
#include "stillmap/moving_box.hpp"
#include "stillmap/parameters.hpp"
#include "stillmap/stamped_pose.hpp"
#include "stillmap/tile_store.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// The stages of process(), for whoever measures them. Evidence that no label of the scan needs is in upkeep.
enum class Stage { kRangeImage, kInsertion, kEvidence, kReplay, kDecision, kObjects, kUpkeep };
inline constexpr int kStageCount = 7;
const char* to_string(Stage stage);

/// The core has no clock: a listener may keep one. With several threads the objects of a scan are found
/// beside its insertion, replay and decision, and counted there.
class StageListener {
 public:
  virtual ~StageListener() = default;
  virtual void stage_ended(Stage stage) = 0;  ///< in the order of Stage, once for each process()
};

/// The method: feed it scans, it labels their points and keeps the map. Not thread-safe: one caller at a
/// time.
class Mapper {
 public:
  /// Throws std::invalid_argument, naming each parameter that is out of range.
  explicit Mapper(const Parameters& parameters);
  ~Mapper();
  Mapper(Mapper&&) noexcept;
  Mapper& operator=(Mapper&&) noexcept;

  /// Judges the points at the scan's own time and updates the map. T_map_sensor takes sensor points into the
  /// map; its translation is the origin of the rays. Throws std::invalid_argument on a pose that is not
  /// finite, not rigid or out of the map's reach; the map then is as it was. The result is valid until the
  /// next call.
  const ScanLabels& process(const Scan& scan, const Eigen::Isometry3d& T_map_sensor);
  /// process() in two steps, for whoever passes the labels on in between: label() says what process() says,
  /// upkeep() then brings up to date what no label of this scan depends on. What looks at the map, the next
  /// label() included, does the upkeep itself where it is still due: results are the same.
  const ScanLabels& label(const Scan& scan, const Eigen::Isometry3d& T_map_sensor);
  void upkeep();

  /// Judges the points of an earlier scan by the map as it is now. `online` is what process() said then.
  ScanLabels relabel(const Scan& scan, const Eigen::Isometry3d& T_map_sensor, const ScanLabels& online) const;

  /// The map in memory: all of it, or with rolling_radius_m what lies within.
  MapSnapshotPtr snapshot() const;
  /// The complete state of the map in memory, and the way back: imported blocks replace those at the same
  /// place, the others stay. Throws std::invalid_argument when the voxel size differs or a block has a
  /// problem(); the map then is as it was.
  MapContents export_map() const;
  void import_map(const MapContents& contents);
  /// The same tile by tile; a tile that is not in memory has no blocks.
  std::vector<TileKey> tiles() const;
  std::vector<BlockContents> export_tile(const TileKey& key) const;

  /// As if the mapper had been made anew and imported the map.
  void load_map(const MapContents& contents);
  /// Why the map says what it says of a place, by the scans that are kept to judge new voxels.
  Explanation explain(const Eigen::Vector3d& point_map_m) const;
  /// Upright boxes around what moves in the scan of the last process(), which is given again.
  std::vector<MovingBox> moving_boxes(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) const;

  /// Repair by hand: forget the voxels whose surface lies in the box, or have them certain of a label. They
  /// return how many there were. Throw std::invalid_argument on an empty box or Label::kInvalid.
  std::size_t clear_box(const Eigen::AlignedBox3d& box_map_m);
  std::size_t relabel_box(const Eigen::AlignedBox3d& box_map_m, Label label);

  /// Moves the map along with a trajectory whose past was corrected, a loop closure: poses of the first LiDAR
  /// after the correction, or how the newest pose was moved, an error that grew with the way since the last
  /// correction. Scans that follow come in the corrected frame. Throw std::invalid_argument, the map as it
  /// was, when submap_length_m is 0 or no pose lies in the time of the scans.
  TrajectoryCorrection correct_trajectory(const std::vector<StampedPose>& corrected);
  TrajectoryCorrection correct_newest_pose(const Eigen::Isometry3d& T_new_old);

  std::uint64_t revision() const;   ///< grows with each change of the map
  std::size_t voxel_count() const;  ///< in memory
  std::int64_t stamp_ns() const;    ///< of the newest scan
  std::size_t scan_count() const;   ///< processed since the start or the last reset()
  void reset();                     ///< forgets map, tile store, history and sensor geometry

  const Parameters& parameters() const;
  /// Other thresholds from the next scan on: p_static_min, p_dynamic_max. The map stays as it is. Throws as
  /// the constructor.
  void set_decision(double p_static_min, double p_dynamic_max);
  const Decision& decision() const;            ///< its two thresholds, eq. (9)
  void set_listener(StageListener* listener);  ///< not owned; nullptr = none
  /// Where tiles go that are farther than rolling_radius_m. Not owned; nullptr = they are forgotten.
  void set_tile_store(TileStore* store);

 private:
  struct State;
  State& up_to_date() const;  ///< after upkeep()
  std::unique_ptr<State> state_;
};

}  // namespace stillmap
