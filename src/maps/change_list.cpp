#include "maps/change_list.hpp"

#include <cstdio>

#include "maps/top_view.hpp"

namespace stillmap {
namespace {

constexpr Rgb kBackground = {255, 255, 255}, kSame = {190, 194, 200}, kAppeared = {0, 150, 60},
              kGone = {214, 30, 42};

std::string rows(const char* format, const char* what, const std::vector<Change>& changes) {
  std::string text;
  for (const Change& change : changes) {
    const Eigen::Vector3d middle = change.extent_m.center(), size = change.extent_m.sizes();
    char row[160];
    std::snprintf(row, sizeof(row), format, what, middle.x(), middle.y(), middle.z(), size.x(), size.y(),
                  size.z(), change.voxels.size());
    text += row;
  }
  return text;
}

Eigen::Vector2d middle_of(const VoxelKey& key, double voxel_size_m) {
  return (key.head<2>().cast<double>().array() + 0.5) * voxel_size_m;
}

void draw(const std::vector<VoxelKey>& voxels, double voxel_size_m, const TopView& view, Rgb color,
          Picture& picture) {
  for (const VoxelKey& key : voxels) {
    const Eigen::Vector2i pixel = view.pixel(middle_of(key, voxel_size_m));
    picture.at(pixel.x(), pixel.y()) = color;
  }
}

Eigen::AlignedBox2d extent_of(const MapDiff& diff) {
  Eigen::AlignedBox2d extent_m;
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(diff.voxel_size_m / 2);
  for (const VoxelKey& key : diff.same) {
    const Eigen::Vector2d middle = middle_of(key, diff.voxel_size_m);
    extent_m.extend(Eigen::AlignedBox2d(middle - half, middle + half));
  }
  for (const std::vector<Change>* changes : {&diff.appeared, &diff.gone})
    for (const Change& change : *changes)
      extent_m.extend(Eigen::AlignedBox2d(change.extent_m.min().head<2>(), change.extent_m.max().head<2>()));
  return extent_m;
}

}  // namespace

std::string table_of(const MapDiff& diff) {
  char head[128], foot[160];
  std::snprintf(head, sizeof(head), "%-9s %24s %21s %8s\n", "", "middle x, y, z (m)", "extent (m)", "voxels");
  std::snprintf(foot, sizeof(foot),
                "same %zu voxels; where only the first map has something around %zu, only the second %zu\n",
                diff.same.size(), diff.only_first, diff.only_second);
  const char* row = "%-9s %8.2f%8.2f%8.2f %7.2f%7.2f%7.2f %8zu\n";
  return head + rows(row, "appeared", diff.appeared) + rows(row, "gone", diff.gone) + foot;
}

std::string csv_of(const MapDiff& diff) {
  const char* row = "%s,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%zu\n";
  return "change,x_m,y_m,z_m,length_m,width_m,height_m,voxels\n" + rows(row, "appeared", diff.appeared) +
         rows(row, "gone", diff.gone);
}

MapSnapshot snapshot_of(const std::vector<Change>& changes, const MapDiff& diff) {
  MapSnapshot map;
  map.voxel_size_m = diff.voxel_size_m;
  for (const Change& change : changes)
    for (const VoxelKey& key : change.voxels) {
      const Eigen::Vector3d center = (key.cast<double>().array() + 0.5) * diff.voxel_size_m;
      map.voxels.push_back({center.cast<float>(), 0.0F, Label::kStatic});
    }
  return map;
}

std::string save_diff_picture(const MapDiff& diff, const std::string& path) {
  const TopView view(extent_of(diff), diff.voxel_size_m);
  Picture picture = view.blank(kBackground);
  draw(diff.same, diff.voxel_size_m, view, kSame, picture);
  for (const Change& change : diff.gone) draw(change.voxels, diff.voxel_size_m, view, kGone, picture);
  for (const Change& change : diff.appeared) draw(change.voxels, diff.voxel_size_m, view, kAppeared, picture);
  picture.save(path);
  return view.in_words() + "; green appeared, red went, grey is the same";
}

}  // namespace stillmap
