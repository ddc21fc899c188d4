// Runs under callgrind: one dump for each stage of each measured scan, named after the stage. The sequence is
// simulated and always the same, one thread. Usage: valgrind --tool=callgrind --instr-atstart=no ...
// stage_instructions [SCENE SENSOR]
#include <valgrind/callgrind.h>

#include <cstdio>
#include <exception>

#include "simulation/simulator.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kWarmUp = 12;  // the sensor's geometry is fixed, and there is a map
constexpr std::size_t kMeasured = 3;

class Dumps : public StageListener {
 public:
  void stage_ended(Stage stage) override {
    if (on) CALLGRIND_DUMP_STATS_AT(to_string(stage));  // and begins anew from zero
  }
  bool on = false;
};

void run(const SimulationOptions& options) {
  const Simulator simulator(options);
  Parameters parameters;
  parameters.threads = 1;
  Mapper mapper(parameters);
  Dumps dumps;
  mapper.set_listener(&dumps);
  for (std::size_t k = 0; k < kWarmUp + kMeasured; ++k) {
    const Frame frame = simulator.frame(k).frame;
    dumps.on = k >= kWarmUp;
    if (dumps.on) {
      CALLGRIND_START_INSTRUMENTATION;
      CALLGRIND_ZERO_STATS;
    }
    mapper.process(frame.scan, frame.T_map_sensor);
    CALLGRIND_STOP_INSTRUMENTATION;
    if (dumps.on) std::printf("scan %zu: %zu rows\n", k, frame.scan.points.size());
  }
}

}  // namespace
}  // namespace stillmap

int main(int argc, char** argv) {
  stillmap::SimulationOptions options;
  options.scene = argc > 2 ? argv[1] : "plaza";
  options.sensor = argc > 2 ? argv[2] : "vlp16";
  options.scans = 15;
  try {
    stillmap::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stage_instructions: %s\n", error.what());
    return 1;
  }
}
