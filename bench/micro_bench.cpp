// The pieces of the core one by one, on a simulated street with 64 rings. items_per_second counts rows,
// voxels or look-ups, as the name says.
#include <benchmark/benchmark.h>

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

void voxels_in_a_snapshot(benchmark::State& state) {
  Mapper mapper{Parameters{}};
  mapper.process(street().scan, street().T_map_sensor);
  for (auto _ : state) benchmark::DoNotOptimize(mapper.snapshot());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mapper.voxel_count()));
}
BENCHMARK(voxels_in_a_snapshot);

}  // namespace
}  // namespace stillmap
