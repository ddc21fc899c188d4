#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "stillmap/map_contents.hpp"

namespace stillmap {

/// Writes a map piece by piece. The file is whole only after finish().
class MapArchiveWriter {
 public:
  /// Throws std::runtime_error, like all of its functions, when `path` cannot be written.
  MapArchiveWriter(const std::string& path, double voxel_size_m, std::int64_t stamp_ns);
  void add(const BlockContents& block);  ///< a key must not come twice
  void finish();

 private:
  void write_section();
  void write(const std::string& bytes);

  std::string path_;
  std::ofstream stream_;
  std::string section_;
  std::uint32_t section_blocks_ = 0;
  std::uint64_t blocks_ = 0, voxels_ = 0;
};

}  // namespace stillmap
