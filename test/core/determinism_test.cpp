// The same input gives the same output, bit for bit, with any number of threads.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>

#include "simulation/simulator.hpp"
#include "stillmap/mapper.hpp"
#include "stillmap/worker_threads.hpp"

namespace stillmap {
namespace {

struct Output {
  std::vector<ScanLabels> labels;
  MapSnapshotPtr map;
};

std::vector<Frame> recorded(const std::string& scene, const std::string& sensor, std::size_t scans) {
  SimulationOptions options;
  options.scene = scene;
  options.sensor = sensor;
  options.scans = scans;
  return Simulator(options).frames();
}

/// Also where the machine has fewer: a mapper takes no more than TBB allows.
Output processed(const std::vector<Frame>& frames, Parameters p, int threads) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
  p.threads = threads;
  Mapper mapper(p);
  Output output;
  for (const Frame& frame : frames) output.labels.push_back(mapper.process(frame.scan, frame.T_map_sensor));
  output.map = mapper.snapshot();
  return output;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void expect_same(const Output& a, const Output& b) {
  ASSERT_EQ(a.labels.size(), b.labels.size());
  for (std::size_t k = 0; k < a.labels.size(); ++k) {
    EXPECT_TRUE(same_bits(a.labels[k].label, b.labels[k].label)) << "scan " << k;
    EXPECT_TRUE(same_bits(a.labels[k].p_static, b.labels[k].p_static)) << "scan " << k;
    EXPECT_TRUE(same_bits(a.labels[k].reason, b.labels[k].reason)) << "scan " << k;
  }
  ASSERT_EQ(a.map->voxels.size(), b.map->voxels.size());
  for (std::size_t i = 0; i < a.map->voxels.size(); ++i) {
    ASSERT_EQ(a.map->voxels[i].center, b.map->voxels[i].center);
    ASSERT_EQ(a.map->voxels[i].log_odds, b.map->voxels[i].log_odds);
  }
}

TEST(Determinism, AnyNumberOfThreadsAndEveryRun) {
  for (const auto& [scene, sensor] : {std::pair{"plaza", "vlp16"}, std::pair{"orchard", "livox"}}) {
    const std::vector<Frame> frames = recorded(scene, sensor, 12);
    const Output one = processed(frames, preset("default"), 1);
    expect_same(processed(frames, preset("default"), 1), one);
    expect_same(processed(frames, preset("default"), 2), one);
    expect_same(processed(frames, preset("default"), 8), one);
  }
}

TEST(Threads, NoMoreThanAreGivenAreAskedForAndItIsTold) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 3);
  Parameters p;
  p.threads = 3;
  EXPECT_EQ(threads_message(p), "");
  p.threads = 8;
  EXPECT_EQ(threads_message(p), "parameter threads is 8: this machine gives 3, so 3 are used");
  testing::internal::CaptureStderr();
  const Mapper mapper(p);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "TBB's own warning";
}

TEST(Determinism, ThePaperToo) {
  const std::vector<Frame> frames = recorded("rooms", "vlp16", 6);
  expect_same(processed(frames, preset("paper"), 8), processed(frames, preset("paper"), 1));
}

}  // namespace
}  // namespace stillmap
