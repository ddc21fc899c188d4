#include "evaluation/stillmap_method.hpp"

#include <limits>
#include <stdexcept>

#include "io/parameters_yaml.hpp"

namespace stillmap {
namespace {

PointVerdicts verdicts_of(const ScanLabels& labels) {
  PointVerdicts verdicts{labels.label, labels.p_static, labels.reason};
  for (std::size_t row = 0; row < labels.reason.size(); ++row)
    if (labels.reason[row] <= Reason::kOutOfRange)
      verdicts.p_static[row] = std::numeric_limits<float>::quiet_NaN();
  return verdicts;
}

}  // namespace

std::optional<PointVerdicts> StillmapMethod::add(const Frame& frame) {
  try {
    online_.push_back(mapper_.process(frame.scan, frame.T_map_sensor));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error("scan " + frame.name + ": " + error.what());
  }
  return verdicts_of(online_.back());
}

PointVerdicts StillmapMethod::map_verdicts(std::size_t k, const Frame& frame) const {
  return verdicts_of(mapper_.relabel(frame.scan, frame.T_map_sensor, online_.at(k)));
}

std::string StillmapMethod::settings() const {
  return to_yaml(mapper_.parameters());
}

}  // namespace stillmap
