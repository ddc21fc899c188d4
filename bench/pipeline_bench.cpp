// Whole scans through the mapper, on sequences of the project's own simulator, beside two floors measured in
// the same run: copying memory, and touching each coordinate of the scan once.
// Usage: pipeline_bench [SCANS]
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "simulation/simulator.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {
namespace {

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double wall_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

double quantile(std::vector<double> values, double fraction) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))];
}

/// CPU time to copy as many bytes as a scan of n rows has.
double copy_floor_ms(std::size_t n) {
  constexpr int kTimes = 50;
  std::vector<float> from(3 * n, 1.0F), to(3 * n);
  const double start = cpu_ms();
  for (int i = 0; i < kTimes; ++i) {
    from[0] = static_cast<float>(i);
    std::memcpy(to.data(), from.data(), 3 * n * sizeof(float));
    if (to[0] != from[0]) std::abort();  // keeps the copy
  }
  return (cpu_ms() - start) / kTimes;
}

/// CPU time to read each row once.
double touch_floor_ms(const Scan& scan) {
  constexpr int kTimes = 50;
  volatile float kept = 0;
  const double start = cpu_ms();
  for (int i = 0; i < kTimes; ++i) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const Eigen::Vector3f& point : scan.points) sum += point;
    kept = kept + sum.sum();
  }
  return (cpu_ms() - start) / kTimes;
}

/// CPU time of each stage over all scans.
class StageTimes : public StageListener {
 public:
  void start() { last_ms_ = cpu_ms(); }
  void stage_ended(Stage stage) override {
    const double now_ms = cpu_ms();
    total_ms_[static_cast<int>(stage)] += now_ms - last_ms_;
    last_ms_ = now_ms;
  }
  double of(Stage stage) const { return total_ms_[static_cast<int>(stage)]; }

 private:
  double last_ms_ = 0;
  double total_ms_[kStageCount] = {};
};

void run(const std::vector<Frame>& frames, const char* name, int threads) {
  const std::size_t warm_up = frames.size() / 3;  // the sensor's geometry and the first map
  Parameters parameters;
  parameters.threads = threads;
  Mapper mapper(parameters);
  StageTimes stages;
  std::vector<double> cpu, wall, until_labels;
  double rows = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (k == warm_up) mapper.set_listener(&stages);
    const double wall_start = wall_ms(), cpu_start = cpu_ms();
    stages.start();
    mapper.label(frames[k].scan, frames[k].T_map_sensor);
    const double labels_ms = wall_ms() - wall_start;
    mapper.upkeep();
    if (k < warm_up) continue;
    until_labels.push_back(labels_ms);
    cpu.push_back(cpu_ms() - cpu_start);
    wall.push_back(wall_ms() - wall_start);
    rows += static_cast<double>(frames[k].scan.points.size());
  }
  const Scan& last = frames.back().scan;
  const double touch_ms = touch_floor_ms(last), copy_ms = copy_floor_ms(last.points.size());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%-14s %d %7.0f %7.1f %7.1f %7.1f %8.1f %7.3f %7.3f %7.0f %8zu %7.0f |", name, threads,
              rows / static_cast<double>(cpu.size()), quantile(cpu, 0.5), quantile(cpu, 0.99),
              quantile(wall, 0.5), quantile(until_labels, 0.5), touch_ms, copy_ms,
              quantile(cpu, 0.5) / touch_ms, mapper.voxel_count(),
              static_cast<double>(usage.ru_maxrss) / 1024);
  for (int s = 0; s < kStageCount; ++s)
    std::printf(" %.1f", stages.of(static_cast<Stage>(s)) / static_cast<double>(cpu.size()));
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  using namespace stillmap;
  const std::size_t scans = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 60;
  if (scans < 3) {
    std::fprintf(stderr, "pipeline_bench: SCANS is '%s'; give 3 or more\n", argv[1]);
    return 2;
  }
  std::printf(
      "sequence  threads    rows cpu p50 cpu p99 wall50 labels50   touch    copy  /touch   voxels peak MB |");
  for (int s = 0; s < kStageCount; ++s) std::printf(" %s", to_string(static_cast<Stage>(s)));
  std::printf("\n");
  for (const auto& [scene, sensor] :
       {std::pair{"plaza", "vlp16"}, std::pair{"street", "hdl64"}, std::pair{"rooms", "os1_128"}}) {
    SimulationOptions options;
    options.scene = scene;
    options.sensor = sensor;
    options.scans = scans;
    const std::vector<Frame> frames = Simulator(options).frames();
    const std::string name = std::string(scene) + " " + sensor;
    for (const int threads : {1, 2}) run(frames, name.c_str(), threads);
  }
}
