#include "io/tile_folder.hpp"

#include <stdexcept>

#include "io/map_archive.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kMostWaiting = 64;  // tiles; some 20 MB

}  // namespace

TileFolder::TileFolder(const std::string& folder, double voxel_size_m, std::uintmax_t most_bytes, Say say)
    : voxel_size_m_(voxel_size_m), most_bytes_(most_bytes), say_(std::move(say)), files_(folder) {
  worker_ = std::thread(&TileFolder::work, this);
}

TileFolder::~TileFolder() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  work_came_.notify_all();
  worker_.join();
}

void TileFolder::put(const TileKey& key, Tile tile) {
  if (tile.blocks.empty()) return;
  std::unique_lock lock(mutex_);
  if (waiting_.size() >= kMostWaiting) say_once("the disk is too slow, and scans wait for it", "");
  work_done_.wait(lock, [this] { return waiting_.size() < kMostWaiting; });
  waiting_[packed_tile(key)] = {key, std::make_shared<const Tile>(std::move(tile))};
  queue_.push_back(packed_tile(key));
  work_came_.notify_one();
}

Tile TileFolder::get(const TileKey& key) {
  const std::lock_guard lock(mutex_);
  const auto waiting = waiting_.find(packed_tile(key));
  if (waiting != waiting_.end()) return *waiting->second.tile;
  const TileFiles::Stored* const stored = files_.find(key);
  if (stored == nullptr) return {};
  try {
    return {stored->scan, read_map_archive(files_.path_of(key)).blocks};
  } catch (const std::runtime_error& error) {
    say_once("a tile is lost", error.what());
    files_.remove(key);
    return {};
  }
}

std::vector<TileKey> TileFolder::keys() const {
  const std::lock_guard lock(mutex_);
  std::vector<TileKey> keys;
  for (const TileKey& key : files_.keys())
    if (waiting_.count(packed_tile(key)) == 0) keys.push_back(key);
  for (const auto& [packed_key, waiting] : waiting_) keys.push_back(waiting.key);
  return keys;
}

void TileFolder::clear() {
  const std::lock_guard lock(mutex_);
  queue_.clear();
  waiting_.clear();
  files_.remove_all();
}

void TileFolder::wait_until_written() {
  std::unique_lock lock(mutex_);
  work_done_.wait(lock, [this] { return waiting_.empty(); });
}

void TileFolder::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    work_came_.wait(lock, [this] { return closing_ || !queue_.empty(); });
    if (queue_.empty()) return;
    const auto next = waiting_.find(queue_.front());
    queue_.pop_front();
    if (next == waiting_.end()) continue;  // put twice, and the first time wrote the second tile
    const Waiting writing = next->second;
    lock.unlock();
    write(writing);
    lock.lock();
    // In the meantime it may have been put again, which is in the queue, or cleared.
    const auto now = waiting_.find(packed_tile(writing.key));
    if (now == waiting_.end())
      files_.remove(writing.key);
    else if (now->second.tile == writing.tile)
      waiting_.erase(now);
    work_done_.notify_all();
  }
}

void TileFolder::write(const Waiting& next) {
  std::string error;
  try {
    const MapContents map{0, voxel_size_m_, next.tile->blocks};
    write_map_archive(pieces_of(map), files_.path_of(next.key));
  } catch (const std::runtime_error& problem) {
    error = problem.what();
  }
  const std::lock_guard lock(mutex_);
  if (!error.empty()) return say_once("far tiles are lost", error);
  files_.written(next.key, next.tile->scan);
  if (files_.shrink_to(most_bytes_))
    say_once("rolling_disk_mb is reached, and what was written longest ago is removed", files_.run_folder());
}

void TileFolder::say_once(const std::string& what, const std::string& detail) {
  if (!said_.insert(what).second) return;
  say_("rolling map: " + what + (detail.empty() ? "" : ": " + detail));
}

std::unique_ptr<TileFolder> open_tile_folder(const Parameters& parameters, TileFolder::Say say) {
  if (parameters.rolling_radius_m <= 0) return nullptr;
  if (parameters.rolling_directory.empty()) {
    say("rolling map: rolling_directory is empty, so the map beyond rolling_radius_m is forgotten");
    return nullptr;
  }
  return std::make_unique<TileFolder>(parameters.rolling_directory, parameters.voxel_size_m,
                                      static_cast<std::uintmax_t>(parameters.rolling_disk_mb) * 1000000,
                                      std::move(say));
}

}  // namespace stillmap
