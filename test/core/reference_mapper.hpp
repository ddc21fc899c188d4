#pragma once

#include <map>
#include <memory>

#include "core/reference_known_surface.hpp"
#include "core/reference_range_image.hpp"
#include "stillmap/parameters.hpp"
#include "stillmap/types.hpp"

namespace stillmap::reference {

/// A scan as later ones remember it.
struct View {
  Eigen::Isometry3d T_sensor_map;
  std::vector<RangeImage> levels;
};

/// The method without objects, slow and obvious: a std::map of voxels, all of them visited for each scan, the
/// equations written out once more. For up to history_recent + history_spread scans.
class Mapper {
 public:
  explicit Mapper(const Parameters& parameters) : p_(parameters) {}

  std::vector<Label> process(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
    ++scan_;
    const double gap_s = scan_ > 1 ? static_cast<double>(scan.stamp_ns - stamp_ns_) * 1e-9 : 0;
    steady_s_ = std::clamp(gap_s, 0.0, 1.0);
    stamp_ns_ = scan.stamp_ns;
    const auto view = std::make_shared<View>(view_of(scan, T_map_sensor));
    const std::vector<std::pair<Key, Eigen::Vector3d>> born = insert(scan, T_map_sensor);
    if (p_.evidence_goes_to == "nearest_voxel") {
      judge_nearest(*view);
    } else {
      judge_all(*view);
    }
    for (const auto& [key, point] : born) voxels_[key].log_odds = kept(replayed(key, point));
    views_.push_back(view);
    return decide(scan, T_map_sensor);
  }

  const std::map<Key, Voxel>& voxels() const { return voxels_; }
  Key key_of(const Eigen::Vector3d& point_map_m) const {
    const Eigen::Vector3d k = (point_map_m / p_.voxel_size_m).array().floor();
    return {static_cast<int>(k.x()), static_cast<int>(k.y()), static_cast<int>(k.z())};
  }

 private:
  /// What one scan says about one element: the strongest conflict, or else whether it is supported.
  struct Fused {
    double conflict = 0;
    bool support = false;
    double range_m = 1;
  };

  static double kept(double log_odds) { return std::round(log_odds * 2048) / 2048; }

  Direction seen(const Eigen::Vector3d& point_sensor_m) const {
    return {std::atan2(point_sensor_m.y(), point_sensor_m.x()),
            std::atan2(point_sensor_m.z(), point_sensor_m.head<2>().norm()), point_sensor_m.norm()};
  }
  bool usable(const Eigen::Vector3f& point) const {
    const double range_m = point.cast<double>().norm();
    return range_m >= p_.min_range_m && range_m <= p_.max_range_m;
  }
  Eigen::Vector3d surface_of(const Key& key, const Voxel& voxel) const {
    return (Eigen::Vector3d(key[0], key[1], key[2]) + voxel.surface) * p_.voxel_size_m;
  }

  View view_of(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) const {
    constexpr double kRad = 3.14159265358979 / 180;
    std::vector<Direction> returns;
    for (const Eigen::Vector3f& point : scan.points)
      if (usable(point)) returns.push_back(seen(point.cast<double>()));
    View view{T_map_sensor.inverse(), {}};
    for (const double level_deg : p_.angular_levels_deg)
      view.levels.push_back(level_deg > 0
                                ? RangeImage::nearest(returns, level_deg * kRad, p_.max_range_m)
                                : RangeImage::bracketed(returns, p_.ring_spacing_deg * kRad,
                                                        p_.azimuth_step_deg * kRad, p_.max_range_m));
    return view;
  }

  std::vector<std::pair<Key, Eigen::Vector3d>> insert(const Scan& scan,
                                                      const Eigen::Isometry3d& T_map_sensor) {
    std::vector<std::pair<Key, Eigen::Vector3d>> born;
    for (const Eigen::Vector3f& point : scan.points) {
      if (!usable(point)) continue;
      const Eigen::Vector3d point_map_m = T_map_sensor * point.cast<double>();
      const Key key = key_of(point_map_m);
      const auto [it, created] = voxels_.try_emplace(key);
      hit(it->second, point_map_m / p_.voxel_size_m - Eigen::Vector3d(key[0], key[1], key[2]), created);
      if (created) born.emplace_back(key, point_map_m);
    }
    return born;
  }

  void hit(Voxel& voxel, const Eigen::Vector3d& offset, bool created) const {
    if (created) voxel.born = scan_;
    if (voxel.last_hit != scan_) {
      if (voxel.seen_through > 0 && scan_ - voxel.last_hit >= 2) voxel.came_back = true;
      ++voxel.hits;
      voxel.last_hit = scan_;
    }
    const Eigen::Vector3d mean = created ? offset : voxel.surface + 0.25 * (offset - voxel.surface);
    voxel.surface = ((mean * 32).array().floor().max(0).min(31) + 0.5) / 32;
  }

  double level_value(const std::vector<double>& values, std::size_t r) const {
    return values.size() == 1 ? values[0] : values[r];
  }

  /// Eq. (2), (3), (6) at one level.
  void add_level(Fused& fused, double range_m, const std::optional<Span>& measured, std::size_t r) const {
    if (!measured) return;
    const double epsilon_m = level_value(p_.support_threshold_m_r, r);
    const double tau_m = level_value(p_.conflict_scale_r, r) * range_m + level_value(p_.conflict_base_m_r, r);
    const double d_near_m = measured->nearest_m - range_m, d_far_m = measured->farthest_m - range_m;
    if (d_near_m > tau_m) {
      const double g = std::min(1.0, (d_near_m - tau_m) / level_value(p_.conflict_sigma_m_r, r));
      fused.conflict = std::max(fused.conflict, level_value(p_.conflict_rate_r, r) * g);
    } else if (d_near_m <= epsilon_m && d_far_m >= -epsilon_m &&
               d_far_m - d_near_m <= 2 * epsilon_m + 0.1 * range_m) {
      fused.support = true;
    }
  }

  Fused evidence(const View& view, const Eigen::Vector3d& point_map_m) const {
    const Direction d = seen(view.T_sensor_map * point_map_m);
    Fused fused;
    fused.range_m = d.range_m;
    for (std::size_t r = 0; r < view.levels.size(); ++r) add_level(fused, d.range_m, view.levels[r].at(d), r);
    return fused;
  }

  /// Eq. (4), (5), (7), (8). Only one support rate for all levels is used here.
  double updated(double log_odds, const Fused& fused, double conflict_factor = 1, bool full = false) const {
    const double eta = log_odds < 0 && !full ? p_.support_rate_when_dynamic : p_.support_rate_r[0];
    double increment = 0;
    if (fused.conflict > 0) {
      increment = -fused.conflict * conflict_factor;
    } else if (fused.support) {
      increment = eta * (1 - probability(log_odds));
    } else {
      return log_odds;
    }
    increment = std::clamp(increment, -p_.increment_clip, p_.increment_clip);
    return std::clamp((1 - p_.forgetting) * log_odds + increment, p_.log_odds_min, p_.log_odds_max);
  }

  bool must_settle(const Voxel& voxel) const {
    return voxel.moved_in && !voxel.came_back && voxel.log_odds < 0 && p_.settle_time_s > 0;
  }
  double settled(const Voxel& voxel) const {
    return std::min(0.0, voxel.log_odds - p_.log_odds_min * steady_s_ / p_.settle_time_s);
  }

  /// Between beams farther apart than conflict_reach_voxels a conflict counts less.
  double share(double range_m) const {
    constexpr double kRad = 3.14159265358979 / 180;
    const double reach_m = p_.conflict_reach_voxels * p_.voxel_size_m;
    if (reach_m <= 0) return 1;
    const double along = std::min(1.0, reach_m / (p_.ring_spacing_deg * kRad * range_m));
    return std::max(0.15, along * std::min(1.0, reach_m / (p_.azimuth_step_deg * kRad * range_m)));
  }

  /// Every voxel known before compares its own range with the images.
  void judge_all(const View& view) {
    known_surface_.update(voxels_, scan_, p_.p_static_min);
    for (auto& [key, voxel] : voxels_) {
      if (voxel.born == scan_) continue;
      if (voxel.last_hit == scan_ && p_.hit_is_support) {
        if (must_settle(voxel)) {
          voxel.log_odds = kept(settled(voxel));
          continue;
        }
        const bool full = p_.full_support_on_return && voxel.came_back;
        voxel.log_odds = kept(updated(voxel.log_odds, {0, true}, 1, full));
        continue;
      }
      const Fused fused = evidence(view, surface_of(key, voxel));
      if (fused.support && fused.conflict == 0 && must_settle(voxel)) {
        voxel.log_odds = kept(settled(voxel));
        continue;
      }
      if (fused.conflict > 0) ++voxel.seen_through;
      const bool is_porous =
          voxel.came_back || (voxel.seen_through < 8 && known_surface_.is_porous_beside(key));
      const double porous = is_porous ? p_.conflict_porous : 1;
      const double beside =
          fused.conflict > 0 && known_surface_.stands_beside(key, scan_) ? p_.conflict_beside_surface : 1;
      voxel.log_odds =
          kept(updated(voxel.log_odds, fused, porous * beside * std::sqrt(share(fused.range_m))));
    }
  }

  /// The literal reading: at each level only the nearest voxel of a pixel is judged.
  void judge_nearest(const View& view) {
    std::map<Key, Fused> fused;
    for (std::size_t r = 0; r < view.levels.size(); ++r) {
      std::map<std::pair<int, int>, std::pair<double, Key>> nearest;
      for (const auto& [key, voxel] : voxels_) {
        const Direction d = seen(view.T_sensor_map * surface_of(key, voxel));
        if (d.range_m > p_.max_range_m) continue;
        const auto it = nearest.try_emplace(view.levels[r].pixel(d), d.range_m, key).first;
        if (d.range_m < it->second.first) it->second = {d.range_m, key};
      }
      for (const auto& [pixel, element] : nearest)
        add_level(fused[element.second], element.first, view.levels[r].at(pixel), r);
    }
    for (const auto& [key, evidence] : fused)
      voxels_[key].log_odds = kept(updated(voxels_[key].log_odds, evidence));
  }

  double replayed(const Key& key, const Eigen::Vector3d& point_map_m) {
    double log_odds = 0;
    const double factor = known_surface_.is_porous_beside(key) ? p_.conflict_porous : 1;
    if (p_.history_recent + p_.history_spread > 0)
      for (std::size_t i = 0; i < views_.size(); ++i) {
        Fused fused = evidence(*views_[i], point_map_m);
        const auto age = static_cast<int>(views_.size() - i);
        if (fused.conflict == 0 && age < p_.replay_support_min_age) fused.support = false;
        log_odds = updated(log_odds, fused, factor * share(fused.range_m));
      }
    voxels_[key].moved_in = log_odds < 0.75 * p_.log_odds_min;
    return p_.hit_is_support ? updated(log_odds, {0, true}) : log_odds;
  }

  std::vector<Label> decide(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) const {
    std::vector<Label> labels;
    for (const Eigen::Vector3f& point : scan.points) {
      Label label = Label::kInvalid;
      if (usable(point)) {
        const double p = probability(voxels_.at(key_of(T_map_sensor * point.cast<double>())).log_odds);
        label = p >= p_.p_static_min    ? Label::kStatic
                : p <= p_.p_dynamic_max ? Label::kDynamic
                                        : Label::kUncertain;
      } else if (point.norm() > p_.max_range_m) {
        label = Label::kUncertain;
      }
      labels.push_back(label);
    }
    return labels;
  }

  Parameters p_;
  int scan_ = 0;
  std::int64_t stamp_ns_ = 0;
  double steady_s_ = 0;  ///< since the scan before, for settle_time_s
  std::map<Key, Voxel> voxels_;
  KnownSurface known_surface_;
  std::vector<std::shared_ptr<const View>> views_;
};

}  // namespace stillmap::reference
