#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace stillmap {

/// Appends numbers to a byte string, lowest byte first on every machine.
class LittleEndianWriter {
 public:
  explicit LittleEndianWriter(std::string& bytes) : bytes_(bytes) {}

  template <class T>
  void put(T value) {
    static_assert(std::is_integral_v<T>);
    auto rest = static_cast<std::make_unsigned_t<T>>(value);
    char out[sizeof(T)];
    for (char& byte : out) {
      byte = static_cast<char>(rest & 0xFF);
      rest = static_cast<std::make_unsigned_t<T>>(static_cast<std::uint64_t>(rest) >> 8);
    }
    bytes_.append(out, sizeof(T));
  }
  void put(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    put(bits);
  }

 private:
  std::string& bytes_;
};

/// Takes them out again. The caller sees to it that the bytes suffice: rest() tells.
class LittleEndianReader {
 public:
  explicit LittleEndianReader(const std::string& bytes) : at_(bytes.data()), end_(at_ + bytes.size()) {}

  std::size_t rest() const { return static_cast<std::size_t>(end_ - at_); }
  template <class T>
  T get() {
    if constexpr (std::is_same_v<T, double>) {
      const auto bits = get<std::uint64_t>();
      double value = 0;
      std::memcpy(&value, &bits, sizeof(value));
      return value;
    } else {
      std::uint64_t value = 0;
      for (std::size_t i = 0; i < sizeof(T); ++i)
        value |= static_cast<std::uint64_t>(static_cast<unsigned char>(at_[i])) << (8 * i);
      at_ += sizeof(T);
      return static_cast<T>(value);
    }
  }

 private:
  const char *at_, *end_;
};

}  // namespace stillmap
