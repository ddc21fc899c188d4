// On simulated worlds, waiting some scans makes the labels better.
#include <gtest/gtest.h>

#include <cstdio>

#include "evaluation/run_method.hpp"
#include "evaluation/simulated_sequence.hpp"

namespace stillmap {
namespace {

MethodResult run(LabelledSequence& sequence, std::size_t delay) {
  RunOptions options;
  options.delay = delay;
  return run_method(sequence, choose_method("default", Parameters()), options, [] {});
}

class DelayedPass : public testing::TestWithParam<const char*> {};

TEST_P(DelayedPass, ScoresBetterThanAtOnce) {
  SimulationOptions simulation;
  simulation.scene = GetParam();
  simulation.sensor = "vlp16";
  simulation.scans = 40;
  simulation.seed = 5;
  SimulatedSequence sequence(simulation);
  const MethodResult result = run(sequence, 10);
  ASSERT_TRUE(result.delayed);
  EXPECT_EQ(result.delayed->total().points(), result.at_once->total().points());
  const double at_once = *result.at_once->total().figures(Uncertain::kKept).score;
  const double delayed = *result.delayed->total().figures(Uncertain::kKept).score;
  std::printf("  %s: at once %.2f, 10 scans later %.2f\n", GetParam(), at_once, delayed);
  EXPECT_GT(delayed, at_once + 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, DelayedPass, testing::Values("street", "plaza", "highway"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(DelayedPassOfAShortSequence, JudgesEveryScanOnce) {
  SimulationOptions simulation;
  simulation.scene = "plaza";
  simulation.scans = 4;
  SimulatedSequence sequence(simulation);
  for (const std::size_t delay : {1, 3, 4, 20})
    EXPECT_EQ(run(sequence, delay).delayed->scans().size(), 4u) << delay;
  EXPECT_FALSE(run(sequence, 0).delayed);
}

}  // namespace
}  // namespace stillmap
