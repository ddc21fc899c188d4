#include "baselines/removert.hpp"

#include "baselines/settings_text.hpp"
#include "stillmap/projection.hpp"

namespace stillmap {
namespace {

/// The nearest of what falls into each pixel; all directions are in it.
class NearestImage {
 public:
  explicit NearestImage(double pixel_deg)
      : columns_(static_cast<int>(std::ceil(360.0 / pixel_deg))),
        rows_(static_cast<int>(std::ceil(180.0 / pixel_deg))),
        range_m_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0.0F),
        index_(range_m_.size(), 0) {}

  std::size_t pixel(const Spherical& seen) const {
    constexpr float kPi = 3.14159265358979F;
    const int column = static_cast<int>((seen.azimuth_rad + kPi) / (2 * kPi) * static_cast<float>(columns_));
    const int row = static_cast<int>((seen.elevation_rad + 0.5F * kPi) / kPi * static_cast<float>(rows_));
    return static_cast<std::size_t>(std::min(row, rows_ - 1)) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(std::min(column, columns_ - 1));
  }
  void add(const Spherical& seen, std::uint32_t index) {
    const std::size_t at = pixel(seen);
    if (range_m_[at] > 0 && range_m_[at] <= seen.range_m) return;
    range_m_[at] = seen.range_m;
    index_[at] = index;
  }
  float range_m(std::size_t pixel) const { return range_m_[pixel]; }  ///< 0 = nothing
  std::uint32_t index(std::size_t pixel) const { return index_[pixel]; }
  std::size_t size() const { return range_m_.size(); }

 private:
  int columns_, rows_;
  std::vector<float> range_m_;
  std::vector<std::uint32_t> index_;
};

template <class ViewT>
NearestImage image_of(const ViewT& view, double pixel_deg) {
  NearestImage image(pixel_deg);
  for (const Eigen::Vector3f& point : view.returns) image.add(spherical(point), 0);
  return image;
}

template <class ViewT>
Spherical seen_from(const ViewT& view, const Eigen::Vector3d& point_map_m) {
  return spherical((view.T_map_sensor.inverse() * point_map_m).template cast<float>());
}

bool sees_through(float scan_range_m, float map_range_m, double range_share) {
  return scan_range_m > 0 && scan_range_m - map_range_m > static_cast<float>(range_share) * map_range_m;
}

}  // namespace

RemovertSettings RemovertSettings::published() {
  return {};
}

RemovertSettings RemovertSettings::paper() {
  RemovertSettings settings;
  settings.gates.voxel_support = 3;
  settings.gates.neighbourhood_support = 60;
  return settings;
}

std::vector<std::uint8_t> Removert::find_dynamic(const std::vector<Eigen::Vector3d>& points,
                                                 const std::vector<View>& views) const {
  std::vector<std::uint8_t> dynamic(points.size(), 0);
  for (const double pixel_deg : settings_.remove_pixels_deg) {
    std::vector<std::uint8_t> removed = dynamic;  // a level sees the map that the one before left
    for (const View& view : views) {
      const NearestImage scan = image_of(view, pixel_deg);
      NearestImage map(pixel_deg);
      for (std::uint32_t i = 0; i < points.size(); ++i)
        if (dynamic[i] == 0) map.add(seen_from(view, points[i]), i);
      for (std::size_t pixel = 0; pixel < map.size(); ++pixel)
        if (map.range_m(pixel) > 0 &&
            sees_through(scan.range_m(pixel), map.range_m(pixel), settings_.range_share))
          removed[map.index(pixel)] = 1;
    }
    dynamic = std::move(removed);
  }
  for (const double pixel_deg : settings_.revert_pixels_deg) {
    std::vector<std::uint8_t> still_dynamic(points.size(), 0);
    for (const View& view : views) {
      const NearestImage scan = image_of(view, pixel_deg);
      for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (dynamic[i] == 0 || still_dynamic[i] != 0) continue;
        const Spherical seen = seen_from(view, points[i]);
        still_dynamic[i] = sees_through(scan.range_m(scan.pixel(seen)), seen.range_m, settings_.range_share);
      }
    }
    dynamic = std::move(still_dynamic);
  }
  return dynamic;
}

std::string Removert::settings() const {
  return SettingsText()
      .add("voxel_size_m", settings_.voxel_size_m)
      .add("remove_pixels_deg", settings_.remove_pixels_deg)
      .add("revert_pixels_deg", settings_.revert_pixels_deg)
      .add("range_share", settings_.range_share)
      .add(settings_.gates)
      .text();
}

}  // namespace stillmap
