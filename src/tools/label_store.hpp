#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "stillmap/types.hpp"

namespace stillmap {

/// Keeps the labels of all scans of a run on disk, exactly, so that memory does not grow with its length.
class LabelStore {
 public:
  /// The store is an unnamed file on the folder's disk; it is gone with the object.
  explicit LabelStore(const std::string& folder);

  void append(const ScanLabels& labels);
  ScanLabels read(std::size_t scan) const;

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<std::int64_t> offsets_ = {0};  ///< of each scan in points, and the end
};

}  // namespace stillmap
