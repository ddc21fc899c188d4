#include "io/tile_files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace stillmap {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

TileFiles::TileFiles(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw std::runtime_error(folder + ": the rolling map's folder cannot be made: " + error.message());
  lock_folder(folder);
  unsigned number = 0;
  for (const fs::path& path : sorted_entries(folder)) {
    if (!fs::is_directory(path) || std::sscanf(path.filename().c_str(), "run_%u", &number) != 1) continue;
    add_earlier_run(path.string());
  }
  char name[32];
  std::snprintf(name, sizeof(name), "/run_%06u", number + 1);
  run_folder_ = folder + name;
  fs::create_directory(run_folder_);
}

TileFiles::~TileFiles() {
  std::error_code not_empty;  // only a run that stored nothing leaves nothing
  fs::remove(run_folder_, not_empty);
  close(lock_);
}

void TileFiles::lock_folder(const std::string& folder) {
  lock_ = open((folder + "/lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
  if (lock_ < 0) throw std::runtime_error(folder + ": the rolling map's folder is not writable");
  if (flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
  close(lock_);
  throw std::runtime_error(
      folder + ": another stillmap keeps its far tiles here; give each its own rolling_directory");
}

void TileFiles::add_earlier_run(const std::string& run) {
  std::vector<std::pair<fs::file_time_type, File>> files;
  for (const fs::path& path : sorted_entries(run)) {
    if (path.extension() != ".stillmap") continue;
    if (path.filename().string().front() == '.')
      fs::remove(path);  // half written when that run ended
    else
      files.push_back({fs::last_write_time(path), {path.string(), fs::file_size(path), {}, false}});
  }
  std::stable_sort(files.begin(), files.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [time, file] : files) {
    files_[next_number_++] = file;
    bytes_ += file.bytes;
  }
}

std::string TileFiles::path_of(const TileKey& key) const {
  return run_folder_ + "/" + std::to_string(key.x()) + "_" + std::to_string(key.y()) + ".stillmap";
}

const TileFiles::Stored* TileFiles::find(const TileKey& key) const {
  const auto it = stored_.find(packed_tile(key));
  return it == stored_.end() ? nullptr : &it->second;
}

std::vector<TileKey> TileFiles::keys() const {
  std::vector<TileKey> keys;
  for (const auto& [packed_key, stored] : stored_) keys.push_back(stored.key);
  return keys;
}

void TileFiles::written(const TileKey& key, std::uint32_t scan) {
  if (const Stored* const old = find(key)) {  // that file was replaced
    bytes_ -= files_.at(old->file).bytes;
    files_.erase(old->file);
  }
  const File file{path_of(key), fs::file_size(path_of(key)), key, true};
  files_[next_number_] = file;
  bytes_ += file.bytes;
  stored_[packed_tile(key)] = {key, scan, next_number_++};
}

void TileFiles::remove(const TileKey& key) {
  if (const Stored* const stored = find(key)) remove_file(stored->file);
}

void TileFiles::remove_all() {
  for (const TileKey& key : keys()) remove(key);
}

bool TileFiles::shrink_to(std::uintmax_t bytes) {
  if (bytes_ <= bytes) return false;
  while (bytes_ > bytes) remove_file(files_.begin()->first);
  return true;
}

void TileFiles::remove_file(std::uint64_t number) {
  const File file = files_.at(number);
  std::error_code gone;  // somebody tidied up: all the better
  fs::remove(file.path, gone);
  bytes_ -= file.bytes;
  files_.erase(number);
  if (file.is_of_this_run)
    stored_.erase(packed_tile(file.key));
  else
    fs::remove(fs::path(file.path).parent_path(), gone);  // an earlier run's folder, once it is empty
}

}  // namespace stillmap
