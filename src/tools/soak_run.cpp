#include "tools/soak_run.hpp"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "io/looped_sequence.hpp"
#include "io/tile_folder.hpp"
#include "stillmap/mapper.hpp"
#include "tools/run_summary.hpp"
#include "tools/say.hpp"

namespace stillmap {
namespace {

double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  double pages = 0, resident_pages = 0;
  if (!(statm >> pages >> resident_pages))
    throw std::runtime_error("/proc/self/statm: cannot be read; memory cannot be measured here");
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

/// One map on its way, and what it cost since the clock was set anew.
struct Driver {
  Driver(const Parameters& parameters, TileStore* far_tiles) : mapper(parameters) {
    mapper.set_tile_store(far_tiles);
  }

  Mapper mapper;
  EngineClock clock;

  const ScanLabels& drive(const Frame& frame) {
    clock.start_scan();
    const ScanLabels& labels = mapper.process(frame.scan, frame.T_map_sensor);
    clock.end_scan();
    return labels;
  }
  double last_ms() const { return clock.scans().cpu_ms.back(); }
};

/// A lap by a map of the whole way and by one that began a lap before.
struct ComparedLap {
  double old_ms = 0, young_ms = 0;
  std::size_t rows = 0, different = 0;

  void add(const ScanLabels& by_old, const ScanLabels& by_young) {
    rows += by_old.label.size();
    for (std::size_t i = 0; i < by_old.label.size(); ++i) different += by_old.label[i] != by_young.label[i];
  }
  double cost_ratio() const { return old_ms / young_ms; }
  double different_percent() const {
    return 100.0 * static_cast<double>(different) / static_cast<double>(std::max<std::size_t>(1, rows));
  }
};

/// The way travelled, with memory over it.
struct Way {
  std::size_t scans = 0;
  double hours = 0, km = 0, mb = 0, most_mb = 0;
  double half_way_km = 0, half_way_mb = 0, alone_km = 0, alone_mb = 0;
  Eigen::Vector3d place_map_m = Eigen::Vector3d::Zero();

  void go_on(const Frame& frame) {
    const Eigen::Vector3d next = frame.T_map_sensor.translation();
    if (scans++ > 0) km += (next - place_map_m).norm() * 1e-3;
    place_map_m = next;
    hours = static_cast<double>(frame.scan.stamp_ns) * 1e-9 / 3600;
  }
  void weigh(bool is_beyond_half) {
    mb = resident_mb();
    most_mb = std::max(most_mb, mb);
    if (!is_beyond_half || half_way_mb > 0) return;
    half_way_km = km;
    half_way_mb = mb_in_use();
  }
  /// Before a second map comes along, which leaves holes where it lay: growth is told until the last one.
  void weigh_alone() {
    alone_km = km;
    alone_mb = mb_in_use();
  }
  /// Without what the allocator keeps.
  static double mb_in_use() {
    malloc_trim(0);
    return resident_mb();
  }
  double mb_per_km() const { return (alone_mb - half_way_mb) / std::max(1e-6, alone_km - half_way_km); }
};

/// The scans since the clock was set anew.
void print_row(const Way& way, const Driver& driver, const ComparedLap& lap) {
  std::vector<double> cpu_ms = driver.clock.scans().cpu_ms;
  std::sort(cpu_ms.begin(), cpu_ms.end());
  std::printf("%8zu %7.2f %8.3f %8.2f %8.2f %10.1f %9zu %6.2f %12.2f\n", way.scans, way.hours, way.km,
              cpu_ms[cpu_ms.size() / 2], cpu_ms.back(), way.mb, driver.mapper.voxel_count(), lap.cost_ratio(),
              lap.different_percent());
  std::fflush(stdout);
}

void check(const char* what, double seen, double most) {
  std::printf("%-52s %8.2f", what, seen);
  if (most > 0) std::printf("   at most %.2f", most);
  std::printf("\n");
  if (most > 0 && seen > most)
    throw std::runtime_error(std::string(what) + ": " + std::to_string(seen) + " is more than " +
                             std::to_string(most));
}

}  // namespace

void soak(Sequence& lap, const Parameters& parameters, const SoakJob& job) {
  const std::size_t laps = 3, scans = std::max(job.scans, laps * lap.size());
  const std::size_t stretches = std::clamp<std::size_t>(scans / (laps * lap.size()), 1, job.rows);
  LoopedSequence sequence(lap, scans);
  const auto far_tiles = open_tile_folder(parameters, say);
  Driver old(parameters, far_tiles.get());
  Way way;
  double most_different_percent = 0, last_cost_ratio = 0;
  std::printf("    scan   hours       km   cpu_ms   max_ms  memory_mb    voxels   cost  different_%%\n");
  for (std::size_t stretch = 0; stretch < stretches; ++stretch) {
    const std::size_t end = scans * (stretch + 1) / stretches;
    const std::size_t young_from = end - 2 * lap.size(), compared_from = end - lap.size();
    const std::size_t half = (scans - 2 * lap.size()) / 2;
    old.clock = EngineClock();
    for (; way.scans < young_from; way.weigh(way.scans > half)) {  // without the second map
      const Frame frame = sequence.read(way.scans);
      old.drive(frame);
      way.go_on(frame);
    }
    way.weigh_alone();
    Driver young(parameters, nullptr);
    ComparedLap compared;
    while (way.scans < end) {
      const Frame frame = sequence.read(way.scans);
      const ScanLabels& by_old = old.drive(frame);
      const ScanLabels& by_young = young.drive(frame);
      way.go_on(frame);
      if (way.scans <= compared_from) continue;
      compared.add(by_old, by_young);
      compared.old_ms += old.last_ms();
      compared.young_ms += young.last_ms();
    }
    print_row(way, old, compared);
    most_different_percent = std::max(most_different_percent, compared.different_percent());
    last_cost_ratio = compared.cost_ratio();
  }
  check("memory, MB", way.most_mb, job.most_mb);
  check("growth of memory over the second half, MB per km", way.mb_per_km(), job.most_mb_per_km);
  check("cost per scan against a map of one lap", last_cost_ratio, job.most_cost_ratio);
  check("labels that differ from those of a map of one lap, %", most_different_percent,
        job.most_different_percent);
}

}  // namespace stillmap
