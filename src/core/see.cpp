#include "mapper_state.hpp"

namespace stillmap {
namespace {

constexpr float kRad = 0.01745329252F;

SensorGeometry given_geometry(const Parameters& p) {
  return {static_cast<float>(p.ring_spacing_deg) * kRad, static_cast<float>(p.azimuth_step_deg) * kRad};
}

}  // namespace

SensorState& Mapper::State::sensor(int index) {
  while (sensors.size() <= static_cast<std::size_t>(index))
    sensors.push_back({GeometryEstimator(given_geometry(parameters)),
                       ScanHistory(parameters.history_recent, parameters.history_spread)});
  return sensors[static_cast<std::size_t>(index)];
}

LabelledScan& Mapper::State::see(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  project(scan, static_cast<float>(parameters.min_range_m), static_cast<float>(parameters.max_range_m),
          projected);
  SensorState& from = sensor(scan.sensor);
  ++from.scans;
  beams = from.beams = from.geometry.update(projected);
  rolling.move_to(T_map_sensor.translation());
  std::vector<RangeImage> levels;
  Eigen::Isometry3d T_aligned = T_map_sensor;
  at_once([&] { levels = range_images(); },
          [&] {
            if (parameters.align_scans) T_aligned = aligned(T_map_sensor, from.jumps);
          });
  ScanView view(from.scans, T_aligned, std::move(levels));
  view.stamp_ns = scan.stamp_ns;
  view.sensor = static_cast<std::size_t>(scan.sensor);
  return awaits_upkeep.emplace(LabelledScan{std::move(view), T_aligned});
}

std::vector<RangeImage> Mapper::State::range_images() const {
  const auto max_range_m = static_cast<float>(parameters.max_range_m);
  std::vector<RangeImage> levels;
  for (const double level_deg : parameters.angular_levels_deg)
    levels.push_back(level_deg > 0
                         ? RangeImage::nearest(projected, static_cast<float>(level_deg) * kRad, max_range_m)
                         : RangeImage::bracketed(projected, beams, max_range_m));
  return levels;
}

}  // namespace stillmap
