#include "maps/height_picture.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "maps/top_view.hpp"

namespace stillmap {
namespace {

constexpr float kNothing = -std::numeric_limits<float>::infinity();

/// The highest static voxel in each pixel.
struct HeightField {
  int width = 0, height = 0;
  std::vector<float> top_m;
  float at(int column, int row) const { return top_m[static_cast<std::size_t>(row) * width + column]; }
};

HeightField height_field(const MapSnapshot& map, const TopView& view) {
  const Picture blank = view.blank({});
  HeightField field{blank.width(), blank.height(), {}};
  field.top_m.assign(static_cast<std::size_t>(field.width) * field.height, kNothing);
  for (const SnapshotVoxel& voxel : map.voxels) {
    if (voxel.label != Label::kStatic) continue;
    const Eigen::Vector2i pixel = view.pixel(voxel.center.head<2>().cast<double>());
    float& top_m = field.top_m[static_cast<std::size_t>(pixel.y()) * field.width + pixel.x()];
    top_m = std::max(top_m, voxel.center.z());
  }
  return field;
}

/// Heights that nearly all pixels lie between: one lost bird must not take the colours.
std::pair<float, float> usual_heights(const HeightField& field) {
  std::vector<float> heights;
  for (const float top_m : field.top_m)
    if (top_m != kNothing) heights.push_back(top_m);
  const auto quantile = [&](double share) {
    const auto nth = heights.begin() + static_cast<std::ptrdiff_t>(share * (heights.size() - 1));
    std::nth_element(heights.begin(), nth, heights.end());
    return *nth;
  };
  const float low_m = quantile(0.01);
  return {low_m, std::max(low_m + 0.1F, quantile(0.99))};
}

/// Five colours from blue to yellow, of equal steps in lightness; `share` in [0, 1].
Rgb color_of_height(float share) {
  constexpr float kStops[5][3] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
  const float at = std::clamp(share, 0.0F, 1.0F) * 4;
  const int stop = std::min(3, static_cast<int>(at));
  Rgb color;
  for (int c = 0; c < 3; ++c)
    color[c] =
        static_cast<std::uint8_t>(kStops[stop][c] + (at - stop) * (kStops[stop + 1][c] - kStops[stop][c]));
  return color;
}

/// Light from the upper left: slopes that face it are lighter.
float light(const HeightField& field, int column, int row, float pixel_m) {
  const float here = field.at(column, row);
  const float left = field.at(std::max(0, column - 1), row), above = field.at(column, std::max(0, row - 1));
  float rise_m = 0;
  if (left != kNothing) rise_m += here - left;
  if (above != kNothing) rise_m += here - above;
  return 0.85F + 0.25F * std::tanh(rise_m / (4 * pixel_m));
}

}  // namespace

std::string save_height_picture(const MapSnapshot& map, const std::string& path) {
  Eigen::AlignedBox2d extent_m;
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(map.voxel_size_m / 2);
  for (const SnapshotVoxel& voxel : map.voxels) {
    if (voxel.label != Label::kStatic) continue;
    const Eigen::Vector2d middle = voxel.center.head<2>().cast<double>();
    extent_m.extend(Eigen::AlignedBox2d(middle - half, middle + half));
  }
  const TopView view(extent_m, map.voxel_size_m);
  const HeightField field = height_field(map, view);
  const auto [low_m, high_m] = usual_heights(field);
  Picture picture = view.blank({20, 20, 24});
  for (int row = 0; row < field.height; ++row)
    for (int column = 0; column < field.width; ++column) {
      const float top_m = field.at(column, row);
      if (top_m == kNothing) continue;
      const float shade = light(field, column, row, static_cast<float>(map.voxel_size_m));
      Rgb color = color_of_height((top_m - low_m) / (high_m - low_m));
      for (std::uint8_t& c : color) c = static_cast<std::uint8_t>(std::min(255.0F, shade * c));
      picture.at(column, row) = color;
    }
  picture.save(path);
  char heights[64];
  std::snprintf(heights, sizeof(heights), "; blue %.2f m, yellow %.2f m", low_m, high_m);
  return view.in_words() + heights;
}

}  // namespace stillmap
