#include "maps/top_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace stillmap {

TopView::TopView(const Eigen::AlignedBox2d& extent_m, double pixel_m) : low_(extent_m.min()) {
  if (extent_m.isEmpty()) throw std::invalid_argument("the map has no static voxel to draw");
  pixel_m_ = std::max(pixel_m, extent_m.sizes().maxCoeff() / kMostPixels);
  width_ = std::max(1, static_cast<int>(std::ceil(extent_m.sizes().x() / pixel_m_)));
  height_ = std::max(1, static_cast<int>(std::ceil(extent_m.sizes().y() / pixel_m_)));
}

std::string TopView::in_words() const {
  char text[128];
  std::snprintf(text, sizeof(text), "%d x %d pixels of %.3g m, lower left corner at (%.2f, %.2f) m", width_,
                height_, pixel_m_, low_.x(), low_.y());
  return text;
}

}  // namespace stillmap
