#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "io/tile_files.hpp"
#include "stillmap/parameters.hpp"
#include "stillmap/tile_store.hpp"

namespace stillmap {

/// The far tiles of a rolling map: a small .stillmap file for each, in FOLDER/run_NNNNNN, a new one for each
/// TileFolder. A thread of its own writes them, and each is replaced in one step: whatever happens to the
/// process, each file holds a whole tile. When FOLDER grows too large, what was written longest ago leaves
/// first, earlier runs before this one. `say` gets each kind of trouble once, on any thread.
class TileFolder : public TileStore {
 public:
  using Say = std::function<void(const std::string&)>;
  /// Throws std::runtime_error when the folder cannot be made, or another process uses it.
  TileFolder(const std::string& folder, double voxel_size_m, std::uintmax_t most_bytes, Say say);
  ~TileFolder() override;  ///< after all is written

  void put(const TileKey& key, Tile tile) override;  ///< waits only when the disk is far behind
  Tile get(const TileKey& key) override;
  std::vector<TileKey> keys() const override;
  void clear() override;

  void wait_until_written();
  const std::string& run_folder() const { return files_.run_folder(); }

 private:
  struct Waiting {
    TileKey key;
    std::shared_ptr<const Tile> tile;
  };

  void work();
  void write(const Waiting& next);
  void say_once(const std::string& what, const std::string& detail);

  const double voxel_size_m_;
  const std::uintmax_t most_bytes_;
  const Say say_;

  mutable std::mutex mutex_;  ///< for all below
  std::condition_variable work_came_, work_done_;
  TileFiles files_;
  std::deque<std::uint64_t> queue_;
  std::map<std::uint64_t, Waiting> waiting_;  ///< by packed key; the one being written included
  std::set<std::string> said_;
  bool closing_ = false;
  std::thread worker_;
};

/// The folder that the parameters ask for; nullptr when there is nothing to keep. Throws as its constructor.
std::unique_ptr<TileFolder> open_tile_folder(const Parameters& parameters, TileFolder::Say say);

}  // namespace stillmap
