#pragma once

#include <functional>

#include "simulation/laser_return.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/sensor.hpp"
#include "simulation/simulator.hpp"

namespace stillmap::simulation {

/// Where the sensor is; it gives T_map_sensor.
using SensorMotion = std::function<Eigen::Isometry3d(double time_s)>;

/// One sweep: from half a period before its middle to half a period after.
struct Sweep {
  double middle_s = 0;
  double period_s = 0.1;
  std::uint64_t index = 0;
  std::uint64_t seed = 1;
  double recording_end_s = kNever_s;  ///< what moves only after it counts as standing
};

/// Casts the beams of a sweep, each at its own time from where the sensor then is, and compensates the
/// points to the middle of the sweep. The frame's T_map_sensor is the true one, its stamp middle_s.
SimulatedFrame cast_scan(const RayCaster& caster, const SensorModel& sensor,
                         const SensorMotion& T_map_sensor_at, const Sweep& sweep, const ReturnNoise& noise);

}  // namespace stillmap::simulation
