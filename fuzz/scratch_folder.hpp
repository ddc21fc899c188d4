#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "expect.hpp"

namespace stillmap::fuzz {

/// A folder for readers that open files, in memory where the machine has such a place. The process has one,
/// and every input writes its files anew.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = std::filesystem::is_directory("/dev/shm") ? "/dev/shm/stillmap_fuzz.XXXXXX"
                                                                 : "/tmp/stillmap_fuzz.XXXXXX";
    expect(mkdtemp(name.data()) != nullptr, "the scratch folder can be made");
    path_ = name;
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }

  std::string path(const std::string& name) const { return path_ + "/" + name; }
  std::string write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  static const ScratchFolder& instance() {
    static const ScratchFolder folder;
    return folder;
  }

 private:
  std::string path_;
};

}  // namespace stillmap::fuzz
