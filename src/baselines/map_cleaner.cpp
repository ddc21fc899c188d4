#include "baselines/map_cleaner.hpp"

namespace stillmap {

std::optional<PointVerdicts> MapCleaner::add(const Frame& frame) {
  map_.add(frame);
  support_.add(frame);
  View& view = views_.emplace_back(View{frame.T_map_sensor, {}});
  for (const Eigen::Vector3f& point : frame.scan.points)
    if (is_return(point)) view.returns.push_back(point);
  return std::nullopt;
}

void MapCleaner::finish() {
  dynamic_ = find_dynamic(map_.points(), views_);
  views_.clear();
  if (!support_.enabled()) return;
  const StructureGates gates = support_.gates();
  for (std::size_t i = 0; i < dynamic_.size(); ++i)
    if (dynamic_[i] != 0 && !gates.dynamic_may_stand(support_.key_of(map_.points()[i]))) dynamic_[i] = 0;
}

PointVerdicts MapCleaner::map_verdicts(std::size_t k, const Frame&) const {
  const std::vector<std::uint32_t>& point_of_row = map_.point_of_row(k);
  PointVerdicts verdicts;
  verdicts.label.assign(point_of_row.size(), Label::kInvalid);
  for (std::size_t row = 0; row < point_of_row.size(); ++row)
    if (point_of_row[row] != AccumulatedMap::kNone)
      verdicts.label[row] = dynamic_[point_of_row[row]] != 0 ? Label::kDynamic : Label::kStatic;
  return verdicts;
}

}  // namespace stillmap
