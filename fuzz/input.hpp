#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace stillmap::fuzz {

/// The fuzzer's bytes, taken from the front; what lies beyond their end is zero.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : at_(data), rest_(size) {}

  bool empty() const { return rest_ == 0; }

  template <class T>
  T take() {
    T value{};
    const std::size_t bytes = std::min(sizeof(T), rest_);
    if (bytes > 0) std::memcpy(&value, at_, bytes);
    skip(bytes);
    return value;
  }
  /// One of 0 .. count - 1.
  std::size_t choose(std::size_t count) { return take<std::uint8_t>() % count; }

  std::string take_text(std::size_t most) {
    const std::size_t bytes = std::min(most, rest_);
    const std::string text(reinterpret_cast<const char*>(at_), bytes);
    skip(bytes);
    return text;
  }
  /// Up to the next `separator`, which is taken too, or all there is.
  std::string take_part(const std::string& separator) {
    const std::string all(reinterpret_cast<const char*>(at_), rest_);
    const std::size_t end = all.find(separator);
    if (end == std::string::npos) return take_text(rest_);
    const std::string part = take_text(end);
    skip(separator.size());
    return part;
  }
  std::string take_all() { return take_text(rest_); }

 private:
  void skip(std::size_t bytes) {
    at_ += bytes;
    rest_ -= bytes;
  }
  const std::uint8_t* at_;
  std::size_t rest_;
};

}  // namespace stillmap::fuzz
