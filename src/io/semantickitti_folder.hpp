#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/sequence.hpp"

namespace stillmap {

/// A folder in SemanticKITTI layout: velodyne/NNNNNN.bin, poses.txt, optional times.txt (else 10 Hz) and
/// calib.txt. Poses are those of the frame that Tr of calib.txt takes sensor points into (KITTI's left
/// camera); without Tr they are the sensor's own.
class SemanticKittiFolder : public Sequence {
 public:
  /// Throws std::runtime_error when something is missing or the counts do not fit.
  explicit SemanticKittiFolder(const std::string& folder);

  std::size_t size() const override { return scan_files_.size(); }
  Frame read(std::size_t index) override;

 private:
  std::vector<std::string> scan_files_;
  std::vector<Eigen::Isometry3d> T_map_sensor_;
  std::vector<std::int64_t> stamps_ns_;
};

/// Reads a .label file: class in the low 16 bits, instance in the high 16. Throws std::runtime_error when it
/// does not hold one label for each of `expected_count` points.
std::vector<std::uint32_t> read_labels(const std::string& file, std::size_t expected_count);

}  // namespace stillmap
