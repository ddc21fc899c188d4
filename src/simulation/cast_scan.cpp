#include "simulation/cast_scan.hpp"

#include <cmath>

namespace stillmap::simulation {
namespace {

constexpr double kRadPerDeg = M_PI / 180.0;
constexpr double kEdgeShare =
    0.15;  // of the beams looked at twice: enough for a percent or so of mixed ranges

Eigen::Vector3d direction_of(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::cos(azimuth_rad), std::cos(elevation_rad) * std::sin(azimuth_rad),
          std::sin(elevation_rad)};
}

std::uint32_t label_of(const Hit& hit, double moving_since_before_s) {
  std::uint16_t semantic_class = hit.surface.semantic_class;
  if (hit.mover != nullptr) {
    semantic_class = hit.mover->first_move_s <= moving_since_before_s ? hit.mover->class_moving
                                                                      : hit.mover->class_standing;
  }
  return static_cast<std::uint32_t>(semantic_class) | static_cast<std::uint32_t>(hit.instance) << 16;
}

/// The rays of one sweep against the world.
class SweepCaster {
 public:
  SweepCaster(const RayCaster& caster, const SensorModel& sensor, const Sweep& sweep,
              const ReturnNoise& noise)
      : caster_(caster),
        sensor_(sensor),
        noise_(noise),
        movers_(caster.world(), sweep.middle_s - sweep.period_s / 2, sweep.middle_s + sweep.period_s / 2) {}

  std::optional<Hit> cast(const Beam& beam, const Eigen::Isometry3d& T_map_sensor, double time_s,
                          Random* random) {
    if (!noise_.physical) return cast_offset(beam, T_map_sensor, time_s, 0, 0, random);
    const double jitter_rad = sensor_.jitter_deg * kRadPerDeg;
    const double azimuth_off = jitter_rad * random->normal(), elevation_off = jitter_rad * random->normal();
    auto hit = cast_offset(beam, T_map_sensor, time_s, azimuth_off, elevation_off, random);
    if (!hit || !random->chance(kEdgeShare)) return hit;
    // The rim of the footprint may meet something else than its middle.
    const double rim_rad = sensor_.footprint_deg / 2 * kRadPerDeg, around = random->uniform(0, 2 * M_PI);
    auto rim = cast_offset(beam, T_map_sensor, time_s, azimuth_off + rim_rad * std::cos(around),
                           elevation_off + rim_rad * std::sin(around), random);
    if (!rim) return hit;
    if (rim->range_m < hit->range_m) std::swap(hit, rim);
    hit->range_m = mixed_range_m(hit->range_m, rim->range_m, random);
    return hit;
  }

 private:
  std::optional<Hit> cast_offset(const Beam& beam, const Eigen::Isometry3d& T_map_sensor, double time_s,
                                 double azimuth_off, double elevation_off, Random* random) {
    const Eigen::Vector3d direction =
        direction_of(beam.azimuth_rad + azimuth_off, beam.elevation_rad + elevation_off);
    return cast_through_glass({T_map_sensor.translation(), T_map_sensor.linear() * direction}, time_s,
                              random);
  }

  std::optional<Hit> cast_through_glass(const Ray& ray, double time_s, Random* random) {
    constexpr double kPastSurface_m = 1e-3;
    double start_m = 0;
    while (auto hit = caster_.cast({ray.origin + start_m * ray.direction, ray.direction}, time_s,
                                   sensor_.max_range_m - start_m, &movers_)) {
      hit->range_m += start_m;
      const bool goes_through = noise_.physical && random->chance(hit->surface.transparency);
      if (!goes_through) return hit;
      start_m = hit->range_m + kPastSurface_m;
    }
    return std::nullopt;
  }

  const RayCaster& caster_;
  const SensorModel& sensor_;
  const ReturnNoise& noise_;
  RayCaster::MoversInSweep movers_;
};

}  // namespace

SimulatedFrame cast_scan(const RayCaster& caster, const SensorModel& sensor,
                         const SensorMotion& T_map_sensor_at, const Sweep& sweep, const ReturnNoise& noise) {
  SimulatedFrame scan;
  scan.T_map_sensor_true = T_map_sensor_at(sweep.middle_s);
  scan.frame.T_map_sensor = scan.T_map_sensor_true;
  scan.frame.scan.stamp_ns = std::llround(sweep.middle_s * 1e9);
  const Eigen::Isometry3d T_middle_map = scan.T_map_sensor_true.inverse();

  SweepCaster sweep_caster(caster, sensor, sweep, noise);
  const std::vector<Beam> beams = sensor.beams(sweep.index, sweep.period_s);
  double posed_at_share = -1;
  Eigen::Isometry3d T_map_sensor = scan.T_map_sensor_true;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const Beam& beam = beams[i];
    const double time_s = sweep.middle_s + (beam.time_share - 0.5) * sweep.period_s;
    if (beam.time_share != posed_at_share) {
      T_map_sensor = T_map_sensor_at(time_s);
      posed_at_share = beam.time_share;
    }
    Random random(sweep.seed, sweep.index, i);
    const auto hit = sweep_caster.cast(beam, T_map_sensor, time_s, &random);
    if (!hit) continue;
    const auto measured = measure(*hit, noise, &random);
    if (!measured || measured->range_m < sensor.min_range_m) continue;

    const Eigen::Vector3d in_sensor = measured->range_m * direction_of(beam.azimuth_rad, beam.elevation_rad);
    scan.frame.scan.points.emplace_back((T_middle_map * (T_map_sensor * in_sensor)).cast<float>());
    scan.intensity.push_back(measured->intensity);
    scan.ring.push_back(beam.ring);
    scan.labels.push_back(label_of(*hit, sweep.recording_end_s));
    scan.labels_now.push_back(label_of(*hit, sweep.middle_s));
  }
  return scan;
}

}  // namespace stillmap::simulation
