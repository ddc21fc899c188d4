#include "io/looped_sequence.hpp"

#include <stdexcept>

namespace stillmap {

LoopedSequence::LoopedSequence(Sequence& lap, std::size_t size) : lap_(lap), size_(size) {
  if (lap.size() < 2)
    throw std::runtime_error("a sequence of " + std::to_string(lap.size()) +
                             " scans cannot be looped; give one of two or more");
  const Frame first = lap.read(0), before_last = lap.read(lap.size() - 2), last = lap.read(lap.size() - 1);
  const Eigen::Vector3d step = last.T_map_sensor.translation() - before_last.T_map_sensor.translation();
  lap_way_map_m_ = last.T_map_sensor.translation() + step - first.T_map_sensor.translation();
  lap_time_ns_ = 2 * last.scan.stamp_ns - before_last.scan.stamp_ns - first.scan.stamp_ns;
}

Frame LoopedSequence::read(std::size_t index) {
  Frame frame = lap_.read(index % lap_.size());
  const std::size_t laps = index / lap_.size();
  frame.T_map_sensor.pretranslate(static_cast<double>(laps) * lap_way_map_m_);
  frame.scan.stamp_ns += static_cast<std::int64_t>(laps) * lap_time_ns_;
  frame.name = std::to_string(index);
  return frame;
}

}  // namespace stillmap
