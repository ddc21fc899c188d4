#include <algorithm>

#include "for_rows.hpp"
#include "mapper_state.hpp"

namespace stillmap {

// Seats and the far side of a car are seen through its windows, now here, now there, too seldom for evidence
// of their own. What is new, in the outline of a moving vehicle and no deeper than one is long, goes with it.
void Mapper::State::take_insides_along() {
  constexpr float kNearlyAll = 0.8F;
  find_vehicles();
  if (vehicles.empty()) return;
  const auto go_along = [this](std::uint32_t row) {
    settle(row, Reason::kObjectMoves);
    moving_rows.push_back(row);
  };
  // Each object as a whole; what belongs to none, hidden at an edge, for itself.
  rows_inside.assign(clusters.count(), 0);
  std::vector<std::uint32_t> inside;
  find_rows(labels.label.size(), inside, [this](std::size_t row) {
    return labels.reason[row] == Reason::kNeverJudged && in_a_vehicle(row);
  });
  if (inside.empty()) return;
  for (const std::uint32_t row : inside) {
    const std::int32_t object = clusters.of_row()[row];
    if (object == Clusters::kNone)
      go_along(row);
    else
      ++rows_inside[object];
  }
  for (const std::uint32_t row : standing_rows) {
    const std::int32_t object = clusters.of_row()[row];
    if (object == Clusters::kNone || labels.label[row] != Label::kUncertain) continue;
    if (static_cast<float>(rows_inside[object]) >= kNearlyAll * static_cast<float>(object_votes[object].rows))
      go_along(row);
  }
}

bool Mapper::State::in_a_vehicle(std::size_t row) const {
  constexpr float kDeepM = 3.0F;
  return std::any_of(vehicles.begin(), vehicles.end(), [&](const Outline& vehicle) {
    return vehicle.holds(projected.azimuth_rad[row], projected.elevation_rad[row], projected.range_m[row],
                         kDeepM);
  });
}

// Rows that move of objects that move; people have no inside.
void Mapper::State::find_vehicles() {
  constexpr int kRows = 20;
  constexpr float kShortestM = 1.2F;
  vehicles.clear();
  vehicle_of_object.assign(clusters.count(), kNoVehicle);
  for (std::size_t object = 0; object < object_votes.size(); ++object) {
    if (object_votes[object].rows < kRows || !moves(object_votes[object].verdict(kObjectStatic))) continue;
    vehicle_of_object[object] = static_cast<int>(vehicles.size());
    vehicles.emplace_back();
  }
  for (const std::uint32_t row : moving_rows) {
    const std::int32_t object = clusters.of_row()[row];
    if (object == Clusters::kNone || labels.label[row] != Label::kDynamic) continue;
    if (vehicle_of_object[object] == kNoVehicle) continue;
    vehicles[vehicle_of_object[object]].add(projected.azimuth_rad[row], projected.elevation_rad[row],
                                            projected.range_m[row], upright.x_m[row], upright.y_m[row]);
  }
  const auto is_none = [](const Outline& object) {
    return object.rows() < kRows || object.length_m() < kShortestM;
  };
  vehicles.erase(std::remove_if(vehicles.begin(), vehicles.end(), is_none), vehicles.end());
}

}  // namespace stillmap
