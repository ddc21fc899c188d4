#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace stillmap {

using Rgb = std::array<std::uint8_t, 3>;

/// A picture in memory; row 0 is the top one.
class Picture {
 public:
  Picture(int width, int height, Rgb background)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height, background) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Rgb& at(int column, int row) { return pixels_[static_cast<std::size_t>(row) * width_ + column]; }
  const Rgb& at(int column, int row) const {
    return pixels_[static_cast<std::size_t>(row) * width_ + column];
  }

  /// Saves it atomically as .png. Throws std::runtime_error naming the path.
  void save(const std::string& path) const;

 private:
  int width_, height_;
  std::vector<Rgb> pixels_;
};

}  // namespace stillmap
