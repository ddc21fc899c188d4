#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/sequence.hpp"

namespace stillmap {

/// One simulated scan with everything that is known about it. The vectors have the scan's size.
struct SimulatedFrame {
  Frame frame;  ///< its T_map_sensor is noisy, as an odometry would give it
  Eigen::Isometry3d T_map_sensor_true = Eigen::Isometry3d::Identity();
  std::vector<float> intensity;           ///< 0 to 1
  std::vector<std::uint16_t> ring;        ///< 0 = lowest; for a non-repetitive pattern, the laser's line
  std::vector<std::uint32_t> labels;      ///< class | instance << 16; moving if the thing ever moves
  std::vector<std::uint32_t> labels_now;  ///< the same, but what has not moved yet is static
};

/// What to simulate. A scene's own value stands where nothing is given.
struct SimulationOptions {
  std::string scene = "street";         ///< one of scene_names()
  std::string sensor;                   ///< one of sensor_names(); empty = the scene's own
  std::size_t columns = 0;              ///< of a sensor that spins, in a turn; 0 = the sensor's own
  std::uint64_t seed = 1;               ///< changes layout, counts, speeds and every noise
  std::size_t scans = 0;                ///< 0 = the scene's own
  double rate_hz = 10.0;                ///< sweeps in a second
  std::optional<double> ego_speed_mps;  ///< of the sensor's carrier
  double pose_noise_m = 0.01;           ///< sigma along each axis, independent in each scan
  double pose_noise_deg = 0.05;         ///< sigma about each axis, independent in each scan
  double drift_percent = 0.2;           ///< of the way travelled
  double range_noise_m = 0.02;          ///< sigma
  double drop_percent = 1.0;            ///< returns lost at random, beside those lost for a reason
};

/// A simulated recording. frame(k) is a pure function of the options and k: the same bytes in any order of
/// calls. A scan is stamped at the middle of its sweep, the first one with 0, and its points are compensated
/// to that moment with the true motion; as with a real sensor, a point's ray did not start exactly at the
/// scan's origin. Rows are in firing order (all rings of a column, then the next column, clockwise from
/// behind); a ray without return has no row.
class Simulator {
 public:
  /// Throws std::invalid_argument naming the option, what was seen and what is allowed.
  explicit Simulator(const SimulationOptions& options);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;

  std::size_t size() const;
  SimulatedFrame frame(std::size_t k) const;  ///< safe to call from several threads
  std::vector<Frame> frames() const;          ///< all of them, without what is known about them

  static std::vector<std::string> scene_names();
  static std::vector<std::string> sensor_names();

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace stillmap
