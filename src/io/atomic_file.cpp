#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace stillmap {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw std::runtime_error(path + ": cannot be written: " + why);
}

void sync_to_disk(const fs::path& file, const std::string& path) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail(path, std::strerror(errno));
  const int result = fsync(descriptor);
  const int error = errno;
  close(descriptor);
  if (result != 0) fail(path, std::strerror(error));
}

/// Removes the new file unless it took its place.
struct NewFile {
  fs::path path;
  ~NewFile() {
    std::error_code ignored;  // after the rename it is not there
    fs::remove(path, ignored);
  }
};

}  // namespace

void write_atomically(const std::string& path, const std::function<void(const std::string&)>& write) {
  const fs::path target(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder)) fail(path, "the folder " + folder.string() + " does not exist");
  // The extension stays last: writers choose the format by it.
  const std::string unique = ".new-" + std::to_string(getpid());
  const NewFile file{folder / ("." + target.stem().string() + unique + target.extension().string())};
  write(file.path.string());
  sync_to_disk(file.path, path);
  std::error_code error;
  fs::rename(file.path, target, error);
  if (error) fail(path, error.message());
  sync_to_disk(folder, path);
}

void write_text_atomically(const std::string& path, const std::string& text) {
  write_atomically(path, [&](const std::string& file) {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    if (!stream.flush()) fail(path, std::strerror(errno));
  });
}

}  // namespace stillmap
