#include "maps/explanation_picture.hpp"

#include <cmath>

#include "maps/top_view.hpp"

namespace stillmap {
namespace {

constexpr double kSlice_m = 0.5;    ///< half the height of what is drawn of the map
constexpr double kAround_m = 8;     ///< of the map, at least
constexpr double kFarthest_m = 40;  ///< rays are cut there
constexpr int kPixelsOfVoxel = 3;
constexpr Rgb kBackground = {255, 255, 255}, kPlace = {0, 0, 0}, kStanding = {150, 156, 166},
              kUndecided = {240, 176, 0}, kMoving = {150, 0, 90}, kThrough = {226, 60, 50},
              kHit = {0, 160, 70}, kHidden = {200, 204, 210};

struct Ray {
  Eigen::Vector2d from, to;
  Evidence kind;
};

Rgb color_of(Evidence kind) {
  if (kind == Evidence::kConflict) return kThrough;
  return kind == Evidence::kSupport ? kHit : kHidden;
}
Rgb color_of(Label label) {
  if (label == Label::kStatic) return kStanding;
  return label == Label::kDynamic ? kMoving : kUndecided;
}

/// Through the place, from the sensor to where the beam ended.
std::vector<Ray> rays_of(const Explanation& explanation) {
  std::vector<Ray> rays;
  const Eigen::Vector2d place = explanation.place_map_m.head<2>();
  for (const PlaceEvidence& evidence : explanation.evidence) {
    if (evidence.kind == Evidence::kUnknown || !(evidence.range_m > 0)) continue;
    const Eigen::Vector2d way = place - evidence.origin_map_m.head<2>();
    const double length_m = way.norm();
    if (length_m == 0) continue;
    const double beyond_m = length_m * evidence.difference_m() / evidence.range_m;
    rays.push_back({place - way * (std::min(length_m, kFarthest_m) / length_m),
                    place + way * (std::clamp(beyond_m, -kFarthest_m, kFarthest_m) / length_m),
                    evidence.kind});
  }
  return rays;
}

void draw_line(const Eigen::Vector2i& from, const Eigen::Vector2i& to, Rgb color, Picture& picture) {
  const Eigen::Vector2i way = to - from;
  const int steps = std::max(1, way.cwiseAbs().maxCoeff());
  for (int step = 0; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    const Eigen::Vector2i pixel = from + (share * way.cast<double>()).array().round().matrix().cast<int>();
    picture.at(pixel.x(), pixel.y()) = color;
  }
}

void fill(const Eigen::Vector2i& middle, const Eigen::Vector2i& half, Rgb color, Picture& picture) {
  for (int row = std::max(0, middle.y() - half.y());
       row <= std::min(picture.height() - 1, middle.y() + half.y()); ++row)
    for (int column = std::max(0, middle.x() - half.x());
         column <= std::min(picture.width() - 1, middle.x() + half.x()); ++column)
      picture.at(column, row) = color;
}

/// Black on a white edge, open in the middle.
void draw_cross(const Eigen::Vector2i& at, Picture& picture) {
  constexpr int kOpen = 4, kArm = 6, kEdge = 2;
  for (const int edge : {kEdge, 0})
    for (const Eigen::Vector2i& way : {Eigen::Vector2i(1, 0), Eigen::Vector2i(0, 1)})
      for (const int side : {-1, 1})
        fill(at + side * (kOpen + kArm) * way, kArm * way + Eigen::Vector2i(edge + 1, edge + 1) - way,
             edge > 0 ? kBackground : kPlace, picture);
}

void draw_map(const MapSnapshot& map, double z_m, const Eigen::AlignedBox2d& extent_m, const TopView& view,
              Picture& picture) {
  for (const SnapshotVoxel& voxel : map.voxels) {
    const Eigen::Vector3d center = voxel.center.cast<double>();
    if (std::abs(center.z() - z_m) > kSlice_m || !extent_m.contains(center.head<2>())) continue;
    constexpr int kHalf = kPixelsOfVoxel / 2;
    fill(view.pixel(center.head<2>()), {kHalf, kHalf}, color_of(voxel.label), picture);
  }
}

}  // namespace

std::string save_explanation_picture(const Explanation& explanation, const MapSnapshot& map,
                                     const std::string& path) {
  const Eigen::Vector2d place = explanation.place_map_m.head<2>();
  const std::vector<Ray> rays = rays_of(explanation);
  Eigen::AlignedBox2d extent_m(place.array() - kAround_m, place.array() + kAround_m);
  for (const Ray& ray : rays) {
    extent_m.extend(ray.from);
    extent_m.extend(ray.to);
  }
  const TopView view(extent_m, map.voxel_size_m / kPixelsOfVoxel);
  Picture picture = view.blank(kBackground);
  for (const Evidence kind : {Evidence::kOcclusion, Evidence::kSupport, Evidence::kConflict})
    for (const Ray& ray : rays)
      if (ray.kind == kind) draw_line(view.pixel(ray.from), view.pixel(ray.to), color_of(kind), picture);
  draw_map(map, explanation.place_map_m.z(), extent_m, view, picture);
  draw_cross(view.pixel(place), picture);
  picture.save(path);
  return view.in_words() +
         "; the cross is the place; rays: red saw through it, green ended there, light grey ended before; "
         "map "
         "within 0.5 m of its height: grey static, purple dynamic, amber uncertain";
}

}  // namespace stillmap
