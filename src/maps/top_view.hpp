#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "maps/picture.hpp"

namespace stillmap {

/// Where a place of the map lies on a picture from above: x to the right, y upwards.
class TopView {
 public:
  /// Pixels are widened where the picture would have more than kMostPixels along an edge. Throws
  /// std::invalid_argument when there is nothing to see.
  TopView(const Eigen::AlignedBox2d& extent_m, double pixel_m);

  Picture blank(Rgb background) const { return Picture(width_, height_, background); }
  Eigen::Vector2i pixel(const Eigen::Vector2d& place_m) const {
    const Eigen::Vector2i p = ((place_m - low_) / pixel_m_).array().floor().cast<int>();
    return {std::clamp(p.x(), 0, width_ - 1), height_ - 1 - std::clamp(p.y(), 0, height_ - 1)};
  }
  /// "812 x 402 pixels of 0.1 m, lower left corner at (-4.0, 12.3) m"
  std::string in_words() const;

 private:
  static constexpr int kMostPixels = 8000;
  Eigen::Vector2d low_;
  double pixel_m_;
  int width_, height_;
};

}  // namespace stillmap
