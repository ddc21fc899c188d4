// `stillmap soak`, briefly: the same checks as the long drive of scripts/soak.sh.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <string>

#include "io/semantickitti_writer.hpp"
#include "simulation/simulator.hpp"
#include "support/temporary_folder.hpp"

namespace stillmap {
namespace {

struct Outcome {
  int code = -1;
  std::string output;
};

Outcome soak(const std::string& arguments) {
  Outcome run;
  std::FILE* const pipe = popen((STILLMAP_EXECUTABLE " soak " + arguments + " 2>&1").c_str(), "r");
  char buffer[256];
  while (std::fgets(buffer, sizeof(buffer), pipe) != nullptr) run.output += buffer;
  run.code = WEXITSTATUS(pclose(pipe));
  return run;
}

class SoakCommand : public ::testing::Test {
 protected:
  static constexpr std::size_t kLap = 20;

  SoakCommand() {
    SimulationOptions options;
    options.scene = "street";
    options.sensor = "vlp16";
    options.ego_speed_mps = 15;
    options.scans = kLap;
    const Simulator simulator(options);
    SemanticKittiWriter writer(lap);
    for (std::size_t k = 0; k < kLap; ++k) {
      const SimulatedFrame scan = simulator.frame(k);
      writer.write(scan.frame, scan.intensity, scan.labels, scan.labels_now);
    }
  }

  const TemporaryFolder folder;
  const std::string lap = folder.path("street");
};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr char kMemory[] = "";  // a sanitizer's own says nothing
#else
constexpr char kMemory[] = " --most-mb 250 --most-mb-per-km 60";
#endif

/// The two maps that are compared would find them each in other scans.
constexpr char kBeams[] = " --set ring_spacing_deg=2 --set azimuth_step_deg=0.2";

TEST_F(SoakCommand, WithARollingMapCostAndMemoryAreFlat) {
  const Outcome run = soak(lap + " --scans 160 --set max_range_m=30 --set rolling_radius_m=40" +
                           " --set rolling_directory=" + folder.path("far") + kBeams + kMemory +
                           " --most-cost-ratio 1.3 --most-different-percent 2");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_NE(run.output.find("\n      80    0.00    0.1"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("\n     160    0.00    0.2"), std::string::npos) << run.output;
  EXPECT_TRUE(std::filesystem::exists(folder.path("far/run_000001")));
}

TEST_F(SoakCommand, WhatIsNotBoundedFails) {
  const Outcome memory = soak(lap + " --scans 60 --set max_range_m=30 --most-mb 1");
  EXPECT_EQ(memory.code, 1);
  EXPECT_NE(memory.output.find("memory, MB: "), std::string::npos) << memory.output;
  const Outcome cost = soak(lap + " --scans 60 --set max_range_m=30 --most-cost-ratio 0.1");
  EXPECT_EQ(cost.code, 1);
  EXPECT_NE(cost.output.find("is more than 0.1"), std::string::npos) << cost.output;
  const Outcome labels = soak(lap + " --scans 60 --set max_range_m=30 --most-different-percent 1e-9");
  EXPECT_EQ(labels.code, 1);
  EXPECT_NE(labels.output.find("labels that differ"), std::string::npos) << labels.output;
}

}  // namespace
}  // namespace stillmap
