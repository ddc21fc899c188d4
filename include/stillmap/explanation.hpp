#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "stillmap/evidence.hpp"
#include "stillmap/types.hpp"

namespace stillmap {

/// What one scan that the mapper still keeps says about a place, at one angular level.
struct PlaceEvidence {
  std::int64_t stamp_ns = 0;     ///< of the scan
  Eigen::Vector3d origin_map_m;  ///< of its rays
  double level_deg = 0;          ///< pixel size; 0 = the sensor's own beam spacing
  Evidence kind = Evidence::kUnknown;
  float range_m = 0;           ///< of the place, I_M
  MeasuredRange measured;      ///< I_O: what the scan measured in that direction
  float conflict_above_m = 0;  ///< tau of eq. (3): d beyond it is a conflict

  /// d of eq. (2), to the end of the measured span that the case is about.
  float difference_m() const {
    return (kind == Evidence::kOcclusion ? measured.farthest_m : measured.nearest_m) - range_m;
  }
};

/// Why a place of the map has its label.
struct Explanation {
  Eigen::Vector3d asked_map_m;
  Eigen::Vector3d place_map_m;  ///< mean place of the voxel's returns; where there is no voxel, as asked
  bool in_map = false;          ///< a voxel there, or right beside, was hit
  Label label = Label::kUncertain;
  float p_static = 0.5F, log_odds = 0;
  int hits = 0, seen_through = 0;  ///< scans that returned from the voxel, that saw through it; both saturate
  bool came_back = false;          ///< hit again after it was seen through
  std::int64_t newest_stamp_ns = 0;
  std::vector<PlaceEvidence> evidence;  ///< newest scan first; of each all levels
};

/// Of the newest scan that says anything about the place, or nullptr.
const PlaceEvidence* last_evidence(const Explanation& explanation);

/// The explanation for a person: one sentence about the voxel, one about the last scan that says anything,
/// one that counts what all scans say.
std::string in_words(const Explanation& explanation);

const char* to_string(Evidence evidence);

}  // namespace stillmap
