#include "ros/map_directory.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace stillmap {
namespace {

namespace fs = std::filesystem;

fs::path expanded(const std::string& folder) {
  if (folder.empty() || folder.front() != '~') return folder;
  const char* const home = std::getenv("HOME");
  return std::string(home != nullptr ? home : "") + folder.substr(1);
}

}  // namespace

MapDirectory::MapDirectory(const std::string& folder) : folder_(fs::absolute(expanded(folder)).string()) {}

std::string MapDirectory::file_inside(const std::string& path) const {
  if (path.empty()) throw std::runtime_error("path: empty; name a file");
  const fs::path root = fs::weakly_canonical(folder_);
  const fs::path file = fs::weakly_canonical(root / path);  // an absolute path stays as it is
  const auto [root_end, file_at] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  if (root_end != root.end() || file_at == file.end())
    throw std::runtime_error(path + ": lies outside of map_directory (" + root.string() +
                             "); name a file there, or start the node with another map_directory");
  return file.string();
}

std::string MapDirectory::new_file_inside(const std::string& path, bool overwrite) const {
  const std::string file = file_inside(path);
  if (!overwrite && fs::exists(file))
    throw std::runtime_error(file + ": is there already; call with overwrite: true, or name another file");
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw std::runtime_error(folder_ + ": map_directory cannot be made: " + error.message());
  return file;
}

}  // namespace stillmap
