#pragma once

#include <std_msgs/ColorRGBA.h>

#include "stillmap/types.hpp"

namespace stillmap {

inline std_msgs::ColorRGBA color(float r, float g, float b, float a = 1) {
  std_msgs::ColorRGBA color;
  color.r = r;
  color.g = g;
  color.b = b;
  color.a = a;
  return color;
}

/// The colours of rviz/stillmap.rviz.
inline std_msgs::ColorRGBA color_of(Label label) {
  if (label == Label::kStatic) return color(0.75F, 0.75F, 0.75F);
  return label == Label::kDynamic ? color(1.0F, 0.16F, 0.16F) : color(1.0F, 0.69F, 0.0F);
}

}  // namespace stillmap
