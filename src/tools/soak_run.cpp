#include "tools/soak_run.hpp"

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

/// One map on its way, and what it cost.
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

/// The last lap by a map of the whole way and by one that began a lap before.
struct LastLap {
  double old_ms = 0, young_ms = 0;
  std::size_t rows = 0, different = 0;

  void add(const ScanLabels& by_old, const ScanLabels& by_young) {
    rows += by_old.label.size();
    for (std::size_t i = 0; i < by_old.label.size(); ++i) different += by_old.label[i] != by_young.label[i];
  }
  double different_percent() const {
    return 100.0 * static_cast<double>(different) / static_cast<double>(std::max<std::size_t>(1, rows));
  }
};

/// The way travelled, with memory over it.
struct Way {
  std::size_t scans = 0;
  double km = 0, mb = 0, most_mb = 0, weighed_km = 0, half_way_km = 0, half_way_mb = 0;
  Eigen::Vector3d place_map_m = Eigen::Vector3d::Zero();

  void go_on(const Frame& frame) {
    const Eigen::Vector3d next = frame.T_map_sensor.translation();
    if (scans++ > 0) km += (next - place_map_m).norm() * 1e-3;
    place_map_m = next;
  }
  void weigh(bool is_half) {
    mb = resident_mb();
    most_mb = std::max(most_mb, mb);
    weighed_km = km;
    if (!is_half) return;
    half_way_km = km;
    half_way_mb = mb;
  }
  double mb_per_km() const { return (mb - half_way_mb) / std::max(1e-6, weighed_km - half_way_km); }
};

/// The newest `scans` scans.
void print_row(std::size_t scan, const Way& way, const Driver& driver, std::size_t scans) {
  const std::vector<double>& cpu_ms = driver.clock.scans().cpu_ms;
  std::vector<double> window(cpu_ms.end() - static_cast<std::ptrdiff_t>(scans), cpu_ms.end());
  std::sort(window.begin(), window.end());
  std::printf("%8zu %8.3f %9.2f %9.2f %10.1f %12zu\n", scan, way.km, window[window.size() / 2], window.back(),
              way.mb, driver.mapper.voxel_count());
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
  const std::size_t scans = std::max(job.scans, 3 * lap.size());
  const std::size_t young_from = scans - 2 * lap.size(), last_lap_from = scans - lap.size();
  const std::size_t row_every = std::max<std::size_t>(1, scans / 20);
  LoopedSequence sequence(lap, scans);
  const auto far_tiles = open_tile_folder(parameters, say);
  Driver old(parameters, far_tiles.get()), young(parameters, nullptr);
  Way way;
  LastLap last_lap;
  std::printf("    scan       km    cpu_ms    max_ms  memory_mb       voxels\n");
  for (std::size_t k = 0; k < scans; ++k) {
    const Frame frame = sequence.read(k);
    const ScanLabels& by_old = old.drive(frame);
    way.go_on(frame);
    if (k < young_from) way.weigh(k == young_from / 2);  // later there are two maps
    if ((k + 1) % row_every == 0) print_row(k + 1, way, old, row_every);
    if (k < young_from) continue;
    const ScanLabels& by_young = young.drive(frame);
    if (k < last_lap_from) continue;
    last_lap.add(by_old, by_young);
    last_lap.old_ms += old.last_ms();
    last_lap.young_ms += young.last_ms();
  }
  check("memory, MB", way.most_mb, job.most_mb);
  check("growth of memory over the second half, MB per km", way.mb_per_km(), job.most_mb_per_km);
  check("cost per scan against a map of one lap", last_lap.old_ms / last_lap.young_ms, job.most_cost_ratio);
  check("labels that differ from those of a map of one lap, %", last_lap.different_percent(),
        job.most_different_percent);
}

}  // namespace stillmap
