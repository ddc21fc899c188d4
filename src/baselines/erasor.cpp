#include "baselines/erasor.hpp"

#include "baselines/polar_bins.hpp"
#include "baselines/settings_text.hpp"

namespace stillmap {

ErasorSettings ErasorSettings::published() {
  return {};
}

ErasorSettings ErasorSettings::paper() {
  ErasorSettings settings;
  settings.voxel_size_m = 0.05;  // table 1
  // The published 6 is for whole scans; of 1, 2, 3 and 6 the one that serves ERASOR best on 8000 points.
  settings.min_points = 1;
  settings.gates.voxel_support = 4;
  settings.gates.grid_support = 12;
  settings.gates.height_above_ground_m = 0.8;
  return settings;
}

std::vector<std::uint8_t> Erasor::find_dynamic(const std::vector<Eigen::Vector3d>& points,
                                               const std::vector<View>& views) const {
  std::vector<std::uint8_t> dynamic(points.size(), 0);
  for (const View& view : views) {
    const Eigen::Vector3d origin = view.T_map_sensor.translation();
    std::vector<Eigen::Vector3d> upright_returns;
    for (const Eigen::Vector3f& point : view.returns)
      upright_returns.push_back(view.T_map_sensor.linear() * point.cast<double>());
    const double ground_m = ground_below_m(upright_returns);

    const PolarBins::Layout layout{settings_.rings, settings_.sectors, settings_.max_range_m,
                                   ground_m + settings_.min_height_m, ground_m + settings_.max_height_m};
    PolarBins scan_bins(layout), map_bins(layout);
    for (std::uint32_t i = 0; i < upright_returns.size(); ++i) scan_bins.add(upright_returns[i], i);
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (dynamic[i] == 0) map_bins.add(points[i] - origin, i);

    const auto min_points = static_cast<std::size_t>(settings_.min_points);
    for (std::size_t index = 0; index < scan_bins.bins().size(); ++index) {
      const PolarBins::Bin& scan_bin = scan_bins.bins()[index];
      const PolarBins::Bin& map_bin = map_bins.bins()[index];
      if (scan_bin.members.size() < min_points || map_bin.members.size() < min_points) continue;
      if (map_bin.highest_m < ground_m + settings_.free_height_m) continue;
      if (scan_bin.span_m() >= settings_.scan_ratio * map_bin.span_m()) continue;
      std::vector<Eigen::Vector3d> members;
      for (const std::uint32_t i : map_bin.members) members.push_back(points[i]);
      const std::vector<std::uint8_t> ground = find_ground(members, settings_.ground);
      for (std::size_t i = 0; i < members.size(); ++i) dynamic[map_bin.members[i]] = ground[i] == 0;
    }
  }
  return dynamic;
}

std::string Erasor::settings() const {
  return SettingsText()
      .add("voxel_size_m", settings_.voxel_size_m)
      .add("max_range_m", settings_.max_range_m)
      .add("rings", settings_.rings)
      .add("sectors", settings_.sectors)
      .add("min_height_m", settings_.min_height_m)
      .add("max_height_m", settings_.max_height_m)
      .add("free_height_m", settings_.free_height_m)
      .add("scan_ratio", settings_.scan_ratio)
      .add("min_points", settings_.min_points)
      .add("ground_iterations", settings_.ground.iterations)
      .add("ground_lowest_points", settings_.ground.lowest_points)
      .add("ground_seed_height_m", settings_.ground.seed_height_m)
      .add("ground_plane_distance_m", settings_.ground.plane_distance_m)
      .add(settings_.gates)
      .text();
}

}  // namespace stillmap
