#pragma once

#include <tsl/robin_map.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "stillmap/voxel_key.hpp"

namespace stillmap {

/// Which files lie in the folder of a rolling map, and which was written longest ago: those of earlier runs,
/// then this run's. No thread of its own and no lock.
class TileFiles {
 public:
  struct Stored {
    TileKey key = TileKey::Zero();
    std::uint32_t scan = 0;
    std::uint64_t file = 0;  ///< its number
  };

  /// Begins a run. Throws std::runtime_error when the folder cannot be made, or another process uses it.
  explicit TileFiles(const std::string& folder);
  ~TileFiles();
  TileFiles(const TileFiles&) = delete;
  TileFiles& operator=(const TileFiles&) = delete;

  const std::string& run_folder() const { return run_folder_; }
  std::string path_of(const TileKey& key) const;
  /// This run's file of a tile, or nullptr.
  const Stored* find(const TileKey& key) const;
  std::vector<TileKey> keys() const;

  void written(const TileKey& key, std::uint32_t scan);  ///< path_of(key) now holds it
  void remove(const TileKey& key);
  void remove_all();  ///< of this run
  /// Removes the oldest until the rest is not larger; false when there was nothing to do.
  bool shrink_to(std::uintmax_t bytes);

 private:
  struct File {
    std::string path;
    std::uintmax_t bytes = 0;
    TileKey key = TileKey::Zero();
    bool is_of_this_run = false;
  };

  void lock_folder(const std::string& folder);
  void add_earlier_run(const std::string& run);
  void remove_file(std::uint64_t number);

  std::string run_folder_;
  int lock_ = -1;
  tsl::robin_map<std::uint64_t, Stored, BlockKeyHash> stored_;  ///< by packed key
  std::map<std::uint64_t, File> files_;                         ///< oldest first
  std::uint64_t next_number_ = 0;
  std::uintmax_t bytes_ = 0;
};

}  // namespace stillmap
