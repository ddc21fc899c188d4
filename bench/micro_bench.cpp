// The pieces of the core one by one, on a simulated street with 64 rings. items_per_second counts rows,
// voxels or look-ups, as the name says.
#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>

#include "core/located_rows.hpp"
#include "core/scan_view.hpp"
#include "simulation/simulator.hpp"
#include "stillmap/mapper.hpp"
#include "stillmap/voxel_map.hpp"

namespace stillmap {
namespace {

const Frame& street() {
  static const Frame frame = [] {
    SimulationOptions options;
    options.sensor = "hdl64";
    options.scans = 1;
    return Simulator(options).frame(0).frame;
  }();
  return frame;
}

ProjectedScan projected_street() {
  ProjectedScan projected;
  project(street().scan, 0.4F, 100.0F, projected);
  return projected;
}

void count_rows(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(street().scan.points.size()));
}

void rows_projected(benchmark::State& state) {
  ProjectedScan projected;
  for (auto _ : state) project(street().scan, 0.4F, 100.0F, projected);
  count_rows(state);
}
BENCHMARK(rows_projected);

void rows_into_a_range_image(benchmark::State& state) {
  const ProjectedScan projected = projected_street();
  const SensorGeometry geometry = measure_geometry(projected);
  for (auto _ : state) benchmark::DoNotOptimize(RangeImage::bracketed(projected, geometry, 100.0F));
  count_rows(state);
}
BENCHMARK(rows_into_a_range_image);

void rows_located_in_the_map(benchmark::State& state) {
  const ProjectedScan projected = projected_street();
  LocatedRows rows;
  for (auto _ : state) rows.locate(projected, street().T_map_sensor, 10.0);
  count_rows(state);
}
BENCHMARK(rows_located_in_the_map);

VoxelMap map_of_street() {
  VoxelMap map(0.1);
  for (const Eigen::Vector3f& point : street().scan.points) {
    const VoxelKey key = map.key_of(street().T_map_sensor * point.cast<double>());
    bool created = false;
    map.block(map.find_or_create_block(block_key(key))).find_or_create(place_in_block(key), created);
  }
  return map;
}

void voxels_inserted(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(map_of_street());
  count_rows(state);
}
BENCHMARK(voxels_inserted);

void voxels_looked_up(benchmark::State& state) {
  const VoxelMap map = map_of_street();
  std::vector<VoxelKey> keys;
  for (const Eigen::Vector3f& point : street().scan.points)
    keys.push_back(map.key_of(street().T_map_sensor * point.cast<double>()));
  for (auto _ : state)
    for (const VoxelKey& key : keys) benchmark::DoNotOptimize(map.find(key));
  count_rows(state);
}
BENCHMARK(voxels_looked_up);

void evidence_found(benchmark::State& state) {
  const Parameters parameters;
  const std::vector<LevelModel> models = level_models(parameters);
  const ProjectedScan seen = projected_street();
  std::vector<RangeImage> levels;
  levels.push_back(RangeImage::bracketed(seen, measure_geometry(seen), 100.0F));
  const ScanView view(1, street().T_map_sensor, std::move(levels));
  std::vector<int> told(seen.size());
  for (auto _ : state)
    view.find_told(seen.size(), seen.azimuth_rad.data(), seen.elevation_rad.data(), seen.range_m.data(),
                   models, told.data());
  count_rows(state);
}
BENCHMARK(evidence_found);

/// Keeps the time of one stage of the present scan.
class StageClock : public StageListener {
 public:
  explicit StageClock(Stage stage) : stage_(stage) {}
  void stage_ended(Stage stage) override {
    const auto now = std::chrono::steady_clock::now();
    if (stage == stage_) seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  double seconds = 0;

 private:
  Stage stage_;
  std::chrono::steady_clock::time_point last_;
};

/// One stage of whole scans, driving down the street again and again.
void stage_of_a_scan(benchmark::State& state, Stage stage) {
  static const std::vector<Frame> frames = [] {
    SimulationOptions options;
    options.sensor = "hdl64";
    options.scans = 30;
    return Simulator(options).frames();
  }();
  constexpr std::size_t kWarmUp = 15;
  StageClock clock(stage);
  auto mapper = std::make_unique<Mapper>(Parameters{});
  std::size_t k = 0;
  for (auto _ : state) {
    if (k == frames.size()) {
      mapper = std::make_unique<Mapper>(Parameters{});
      k = 0;
    }
    mapper->set_listener(&clock);
    while (k < kWarmUp) {
      mapper->process(frames[k].scan, frames[k].T_map_sensor);
      ++k;
    }
    mapper->process(frames[k].scan, frames[k].T_map_sensor);
    ++k;
    state.SetIterationTime(clock.seconds);
  }
  count_rows(state);
}
void new_voxels_replayed(benchmark::State& state) {
  stage_of_a_scan(state, Stage::kReplay);
}
BENCHMARK(new_voxels_replayed)->UseManualTime()->Iterations(45);
void rows_decided(benchmark::State& state) {
  stage_of_a_scan(state, Stage::kDecision);
}
BENCHMARK(rows_decided)->UseManualTime()->Iterations(45);

void voxels_in_a_snapshot(benchmark::State& state) {
  Mapper mapper{Parameters{}};
  mapper.process(street().scan, street().T_map_sensor);
  for (auto _ : state) benchmark::DoNotOptimize(mapper.snapshot());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mapper.voxel_count()));
}
BENCHMARK(voxels_in_a_snapshot);

}  // namespace
}  // namespace stillmap
