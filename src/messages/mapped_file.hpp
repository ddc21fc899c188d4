#pragma once

#include <string>
#include <string_view>

namespace stillmap {

/// The bytes of a file, read as they are looked at.
class MappedFile {
 public:
  /// Throws std::runtime_error naming the file.
  explicit MappedFile(const std::string& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return {data_, size_}; }

 private:
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace stillmap
