#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace stillmap {

/// One sweep of a LiDAR. Row i stays row i of the message or file it came from, unusable rows included.
struct Scan {
  std::int64_t stamp_ns = 0;
  std::vector<Eigen::Vector3f> points;  ///< sensor frame, metres; NaN or (0,0,0) = no return
  int sensor = 0;  ///< which LiDAR of the robot it came from: each has its own beams and history
};

/// The decision on a point or voxel, eq. (9).
enum class Label : std::uint8_t {
  kUncertain = 0,  ///< tau_dyn < p_static < tau_sta, or never judged: deferred, not guessed
  kStatic = 1,
  kDynamic = 2,
  kInvalid = 3,  ///< the row holds no usable return
};

/// Why a point has its label.
enum class Reason : std::uint8_t {
  kNoReturn = 0,          ///< NaN, infinite, zero, or nearer than min_range_m
  kOutOfRange = 1,        ///< farther than max_range_m: not judged
  kNeverJudged = 2,       ///< no scan but this one says anything about the place
  kMixedEvidence = 3,     ///< evidence on both sides: between the two thresholds
  kSupported = 4,         ///< other scans returned from this surface
  kSeenThroughNow = 5,    ///< this scan saw through a place that it also hits (edge of a moving thing)
  kSeenThrough = 6,       ///< earlier scans saw through this place
  kObjectMoves = 7,       ///< undecided by itself; belongs to an object whose decided points are dynamic
  kObjectStands = 8,      ///< undecided by itself; belongs to an object or surface that is known to be static
  kReplacedVanished = 9,  ///< new surface right behind surface that vanished: the thing that moved there
  kSeenThroughLater = 10  ///< by scans after the point's own; only from relabel()
};
inline constexpr int kReasonCount = 11;

const char* to_string(Label label);
const char* to_string(Reason reason);

inline constexpr std::int32_t kNoObject = -1;  ///< on the ground, by itself, or not judged

/// What process() says of each row of a scan; all of them have the scan's size.
struct ScanLabels {
  std::vector<Label> label;
  std::vector<float> p_static;  ///< probability of standing; 0.5 where nothing is known
  std::vector<Reason> reason;
  std::vector<std::int32_t> object;  ///< rows of one number hang together in this scan; or kNoObject
};

struct LabelCounts {
  std::size_t uncertain = 0, is_static = 0, dynamic = 0, invalid = 0;
};
LabelCounts count(const ScanLabels& labels);

}  // namespace stillmap
