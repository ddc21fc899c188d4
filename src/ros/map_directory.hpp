#pragma once

#include <string>

namespace stillmap {

/// The folder that map files named by a service call must lie in. Whoever can call a service can otherwise
/// write and read wherever the node can.
class MapDirectory {
 public:
  /// "~" at the front is the home folder. The folder need not be there.
  explicit MapDirectory(const std::string& folder);

  /// The file of a service call; a path that is not absolute begins in the folder. Throws std::runtime_error,
  /// with what to do, when it lies elsewhere, also by ".." or by a link.
  std::string file_inside(const std::string& path) const;
  /// The same for a file that is to be written: the folder is made, and a file that is there is kept unless
  /// `overwrite`.
  std::string new_file_inside(const std::string& path, bool overwrite) const;

 private:
  std::string folder_;
};

}  // namespace stillmap
