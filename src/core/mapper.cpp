#include "stillmap/mapper.hpp"

#include <algorithm>

#include "mapper_checks.hpp"
#include "mapper_state.hpp"
#include "stillmap/worker_threads.hpp"

namespace stillmap {
namespace {

/// relabel() looks at columns so far around a return (structure_gates.cpp).
constexpr double kColumnsAround_m = 4.0;

Recursion recursion_of(const Parameters& p) {
  return {static_cast<float>(p.increment_clip), static_cast<float>(p.forgetting),
          static_cast<float>(p.log_odds_min), static_cast<float>(p.log_odds_max)};
}

/// A return from the element itself is support at every level.
FusedEvidence hit_evidence(const std::vector<LevelModel>& models) {
  FusedEvidence hit;
  for (const LevelModel& model : models) hit.support(model);
  return hit;
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
      arena(worker_threads(p)),
      every_voxel_is_judged(p.evidence_goes_to == "every_voxel") {
  if (p.hit_is_support) untold.set_log_odds(recursion(0, own_hit.increment(0)));
}

Mapper::Mapper(const Parameters& parameters) : state_(std::make_unique<State>(parameters)) {}
Mapper::~Mapper() = default;
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;

const ScanLabels& Mapper::process(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  const ScanLabels& labels = label(scan, T_map_sensor);
  upkeep();
  return labels;
}

const ScanLabels& Mapper::label(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) {
  require_sensor(scan.sensor);
  require_usable(T_map_sensor, parameters().voxel_size_m);
  State& s = up_to_date();
  ++s.scan_count;
  ++s.revision;
  s.go_on_to(scan.stamp_ns);
  s.arena.run([&] {
    const LabelledScan& seen = s.see(scan, T_map_sensor);
    const ScanView& view = seen.view;  // I_O at all levels, eq. (2)
    const Eigen::Isometry3d& T_aligned = seen.T_map_sensor;
    s.ended(Stage::kRangeImage);
    s.located.locate(s.projected, T_aligned, s.map.inverse_voxel_size());
    const auto judge = [&] {
      s.insert();
      s.ended(Stage::kInsertion);
      s.apply_evidence_to_hits(view);  // eq. (2) to (8) for the voxels known before that this scan hit
      s.ended(Stage::kEvidence);
      s.replay_history(T_aligned);  // the same for the new ones, with earlier scans
      s.ended(Stage::kReplay);
      s.decide(view);  // eq. (9)
      s.ended(Stage::kDecision);
    };
    const bool resolves = s.parameters.resolve_objects;
    at_once(judge, [&] {
      if (resolves) s.find_objects(T_aligned);
    });
    if (resolves) s.resolve_objects(scan, T_aligned, view);
    if (s.parameters.calibrate_p_static) s.calibrate();
    s.ended(Stage::kObjects);
  });
  return s.labels;
}

void Mapper::upkeep() {
  up_to_date();
}

Mapper::State& Mapper::up_to_date() const {
  if (state_->awaits_upkeep) state_->upkeep();
  return *state_;
}

void Mapper::State::upkeep() {
  arena.run([this] {
    ScanView& view = awaits_upkeep->view;
    if (parameters.resolve_objects) remember_moving();
    if (parameters.doubt_beside_movers) doubt_beside_movers();
    apply_evidence_to_others(view);  // eq. (2) to (8) for the voxels that no row of the scan lies in
    if (submaps.enabled()) remember_for_corrections(view, awaits_upkeep->T_map_sensor);
    rolling.leave(view.origin_map_m, scan_count);
    ScanHistory& history = sensors[view.sensor].history;
    history.add(std::move(view));
  });
  awaits_upkeep.reset();
  ended(Stage::kUpkeep);
}

void Mapper::State::go_on_to(std::int64_t next_stamp_ns) {
  constexpr double kSteadyS = 1.0;  // a longer gap proves no more than that
  const double gap_s = scan_count > 1 ? static_cast<double>(next_stamp_ns - stamp_ns) * 1e-9 : 0.0;
  stamp_ns = next_stamp_ns;
  if (parameters.settle_time_s <= 0) return;
  const double share = std::clamp(gap_s, 0.0, kSteadyS) / parameters.settle_time_s;
  settling_step = static_cast<float>(-parameters.log_odds_min * share);
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
