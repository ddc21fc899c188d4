#include "stillmap/mapper.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "mapper_state.hpp"

namespace stillmap {
namespace {

/// relabel() looks at columns so far around a return (structure_gates.cpp).
constexpr double kColumnsAround_m = 4.0;
constexpr float kRad = 0.01745329252F;

Recursion recursion_of(const Parameters& p) {
  return {static_cast<float>(p.increment_clip), static_cast<float>(p.forgetting),
          static_cast<float>(p.log_odds_min), static_cast<float>(p.log_odds_max)};
}

SensorGeometry given_geometry(const Parameters& p) {
  return {static_cast<float>(p.ring_spacing_deg) * kRad, static_cast<float>(p.azimuth_step_deg) * kRad};
}

/// A return from the element itself is support at every level.
FusedEvidence hit_evidence(const std::vector<LevelModel>& models) {
  FusedEvidence hit;
  for (const LevelModel& model : models) hit.support(model);
  return hit;
}

void require_valid(const Parameters& parameters) {
  const std::vector<std::string> found = problems(parameters);
  if (found.empty()) return;
  std::ostringstream text;
  for (const std::string& problem : found) text << (text.tellp() > 0 ? "; " : "") << problem;
  throw std::invalid_argument(text.str());
}

void require_usable(const Eigen::Isometry3d& T_map_sensor, double voxel_size_m) {
  const Eigen::Matrix3d R = T_map_sensor.linear();
  if (!T_map_sensor.matrix().allFinite())
    throw std::invalid_argument("T_map_sensor: not finite; the scan is not used");
  if (!(R * R.transpose()).isIdentity(1e-3) || R.determinant() < 0)
    throw std::invalid_argument("T_map_sensor: its rotation is not a rotation matrix; the scan is not used");
  const double reach_m = kVoxelKeyLimit * voxel_size_m;
  if (T_map_sensor.translation().cwiseAbs().maxCoeff() > reach_m) {
    std::ostringstream text;
    text << "T_map_sensor: (" << T_map_sensor.translation().transpose()
         << ") m is farther from the origin than the " << reach_m
         << " m that a map of this voxel_size_m reaches; the scan is not used. Has the odometry failed?";
    throw std::invalid_argument(text.str());
  }
}

void require_sensor(int sensor) {
  constexpr int kMostSensors = 16;
  if (sensor < 0 || sensor >= kMostSensors)
    throw std::invalid_argument("scan of sensor " + std::to_string(sensor) + ": number them from 0 to " +
                                std::to_string(kMostSensors - 1) + "; the scan is not used");
}

}  // namespace

Mapper::State::State(const Parameters& p)
    : parameters((require_valid(p), p)),
      models(level_models(p)),
      recursion(recursion_of(p)),
      decision(decision_of(p)),
      support_tables(models, recursion, p.full_support_on_return),
      map(p.voxel_size_m),
      rolling(map, reach_m() + kColumnsAround_m, p.rolling_radius_m),
      submaps(p.submap_length_m),
      own_hit(hit_evidence(models)),
      arena(p.threads),
      every_voxel_is_judged(p.evidence_goes_to == "every_voxel") {
  if (p.hit_is_support) untold.set_log_odds(recursion(0, own_hit.increment(0)));
}

Mapper::Mapper(const Parameters& parameters) : state_(std::make_unique<State>(parameters)) {}
Mapper::~Mapper() = default;
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;

const ScanLabels& Mapper::process(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  require_sensor(scan.sensor);
  State& s = *state_;
  require_usable(T_map_sensor, s.parameters.voxel_size_m);
  ++s.scan_count;
  ++s.revision;
  s.go_on_to(scan.stamp_ns);
  s.arena.execute([&] {
    ScanView view = s.view_of(scan, T_map_sensor);  // I_O at all levels, eq. (2)
    s.ended(Stage::kRangeImage);
    s.rolling.move_to(T_map_sensor.translation(), s.scan_count);
    s.insert(T_map_sensor);
    s.ended(Stage::kInsertion);
    s.evidence_of(view);  // eq. (2) to (8) for the voxels known before
    s.ended(Stage::kEvidence);
    s.replay_history(T_map_sensor);  // the same for the new ones, with earlier scans
    s.ended(Stage::kReplay);
    s.decide(view);  // eq. (9)
    s.ended(Stage::kDecision);
    if (s.parameters.resolve_objects) s.resolve_objects(scan, T_map_sensor, view);
    if (s.parameters.calibrate_p_static) s.calibrate();
    s.ended(Stage::kObjects);
    if (s.submaps.enabled()) s.remember_for_corrections(scan, T_map_sensor, view);
    s.sensor(scan.sensor).history.add(std::move(view));
  });
  return s.labels;
}

SensorState& Mapper::State::sensor(int index) {
  while (sensors.size() <= static_cast<std::size_t>(index))
    sensors.push_back({GeometryEstimator(given_geometry(parameters)),
                       ScanHistory(parameters.history_recent, parameters.history_spread)});
  return sensors[static_cast<std::size_t>(index)];
}

void Mapper::State::go_on_to(std::int64_t next_stamp_ns) {
  constexpr double kSteadyS = 1.0;  // a longer gap proves no more than that
  const double gap_s = scan_count > 1 ? static_cast<double>(next_stamp_ns - stamp_ns) * 1e-9 : 0.0;
  stamp_ns = next_stamp_ns;
  if (parameters.settle_time_s <= 0) return;
  const double share = std::clamp(gap_s, 0.0, kSteadyS) / parameters.settle_time_s;
  settling_step = static_cast<float>(-parameters.log_odds_min * share);
}

ScanView Mapper::State::view_of(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  const auto max_range_m = static_cast<float>(parameters.max_range_m);
  project(scan, static_cast<float>(parameters.min_range_m), max_range_m, projected);
  SensorState& from = sensor(scan.sensor);
  ++from.scans;
  beams = from.beams = from.geometry.update(projected);
  std::vector<RangeImage> levels;
  for (const double level_deg : parameters.angular_levels_deg)
    levels.push_back(level_deg > 0
                         ? RangeImage::nearest(projected, static_cast<float>(level_deg) * kRad, max_range_m)
                         : RangeImage::bracketed(projected, beams, max_range_m));
  ScanView view(from.scans, T_map_sensor, std::move(levels));
  view.stamp_ns = scan.stamp_ns;
  view.sensor = static_cast<std::size_t>(scan.sensor);
  return view;
}

void Mapper::State::evidence_of(const ScanView& view) {
  if (every_voxel_is_judged)
    apply_evidence(view);
  else
    apply_evidence_to_nearest(view);
}

std::size_t Mapper::voxel_count() const {
  return state_->rolling.voxel_count();
}
std::int64_t Mapper::stamp_ns() const {
  return state_->stamp_ns;
}
std::size_t Mapper::scan_count() const {
  return state_->scan_count;
}
std::uint64_t Mapper::revision() const {
  return state_->revision;
}
const Parameters& Mapper::parameters() const {
  return state_->parameters;
}
const Decision& Mapper::decision() const {
  return state_->decision;
}
void Mapper::set_decision(double p_static_min, double p_dynamic_max) {
  Parameters changed = state_->parameters;
  changed.p_static_min = p_static_min;
  changed.p_dynamic_max = p_dynamic_max;
  require_valid(changed);
  state_->parameters = changed;
  state_->decision = decision_of(changed);
}
void Mapper::set_listener(StageListener* listener) {
  state_->listener = listener;
}

void Mapper::set_tile_store(TileStore* store) {
  state_->rolling.set_store(store);
}

void Mapper::reset() {
  TileStore* const store = state_->rolling.store();
  auto fresh = std::make_unique<State>(Parameters(state_->parameters));
  fresh->listener = state_->listener;
  fresh->revision = state_->revision + 1;
  fresh->rolling.set_store(store);
  state_ = std::move(fresh);
  if (store != nullptr) store->clear();
}

}  // namespace stillmap
