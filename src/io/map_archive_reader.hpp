#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "stillmap/map_contents.hpp"

namespace stillmap {

/// Reads a map piece by piece. Throws std::runtime_error with the path, what was found and what to do when
/// the file is foreign, of another version, cut off or damaged; it never asks for more memory than a section
/// and its blocks take.
class MapArchiveReader {
 public:
  explicit MapArchiveReader(const std::string& path);
  double voxel_size_m() const { return voxel_size_m_; }
  std::int64_t stamp_ns() const { return stamp_ns_; }
  /// Appends the next section's blocks; false at the end of a whole file.
  bool next(std::vector<BlockContents>& blocks);

 private:
  std::string read(std::size_t bytes);
  bool end(const std::string& totals);

  std::string path_;
  std::ifstream stream_;
  double voxel_size_m_ = 0;
  std::int64_t stamp_ns_ = 0;
  std::uint64_t blocks_ = 0, voxels_ = 0;
};

}  // namespace stillmap
