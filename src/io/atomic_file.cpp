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

/// A file that only this process makes: nobody can have put a link there that leads elsewhere. Others may
/// read it, not write. It is removed unless it took its place.
class NewFile {
 public:
  NewFile(const fs::path& file, const std::string& target) : path(file) {
    remove();  // half written by a process of the same number that was killed
    const int descriptor = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
    if (descriptor < 0) fail(target, std::strerror(errno));
    close(descriptor);
  }
  ~NewFile() { remove(); }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  const fs::path path;

 private:
  void remove() {
    std::error_code ignored;  // mostly it is not there
    fs::remove(path, ignored);
  }
};

/// The message with the name that the user knows.
std::string with_name(std::string message, const std::string& name, const std::string& known) {
  const std::size_t at = message.find(name);
  return at == std::string::npos ? message : message.replace(at, name.size(), known);
}

}  // namespace

void write_atomically(const std::string& path, const std::function<void(const std::string&)>& write) {
  const fs::path target(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder)) fail(path, "the folder " + folder.string() + " does not exist");
  // The extension stays last: writers choose the format by it.
  const std::string unique = ".new-" + std::to_string(getpid());
  const NewFile file(folder / ("." + target.stem().string() + unique + target.extension().string()), path);
  try {
    write(file.path.string());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(with_name(error.what(), file.path.string(), path));
  }
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
