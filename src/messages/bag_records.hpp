#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stillmap {

/// One record of a bag, format 2.0: named fields and data.
struct BagRecord {
  static constexpr std::uint8_t kMessage = 2, kFileHeader = 3, kIndex = 4, kChunk = 5, kChunkInfo = 6,
                                kConnection = 7;
  std::size_t at = 0;  ///< first byte
  std::map<std::string_view, std::string_view> fields;
  std::string_view data;

  std::uint8_t op() const { return number<std::uint8_t>("op"); }
  /// Throws std::runtime_error when the field is missing or of another size.
  template <class T>
  T number(const char* name) const {
    const auto field = fields.find(name);
    if (field == fields.end() || field->second.size() != sizeof(T))
      throw std::runtime_error("the record at byte " + std::to_string(at) + " has no valid field '" + name +
                               "'");
    T value;
    std::memcpy(&value, field->second.data(), sizeof(T));
    return value;
  }
};

/// Takes records one after the other from bytes. Throws std::runtime_error when one reaches past the end or
/// its fields do not fill its header.
class BagRecords {
 public:
  explicit BagRecords(std::string_view bytes, std::size_t at = 0) : bytes_(bytes), at_(at) {}
  bool next(BagRecord& record);

 private:
  std::string_view bytes_;
  std::size_t at_;
};

/// "name=value" parts, each after its length. Throws std::runtime_error, also when a name comes twice.
std::map<std::string_view, std::string_view> bag_fields(std::string_view bytes);

}  // namespace stillmap
