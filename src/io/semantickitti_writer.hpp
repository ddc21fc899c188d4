#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/sequence.hpp"

namespace stillmap {

/// Writes a sequence as a SemanticKITTI folder: velodyne/, labels/, labels_now/, poses.txt, calib.txt (Tr is
/// the identity: poses take sensor points into the map) and times.txt. Clouds are named by the frame.
class SemanticKittiWriter {
 public:
  /// Creates the folder; throws std::runtime_error if it already holds a sequence or cannot be written.
  explicit SemanticKittiWriter(const std::string& folder);

  /// All vectors have the scan's size. Throws std::runtime_error naming the file that could not be written.
  void write(const Frame& frame, const std::vector<float>& intensity,
             const std::vector<std::uint32_t>& labels, const std::vector<std::uint32_t>& labels_now);

 private:
  std::filesystem::path folder_;
  std::ofstream poses_, times_;
};

}  // namespace stillmap
