// p_static is the share of points like it that stand, on places and seeds that were not used to fit it.
#include <gtest/gtest.h>

#include <cstdio>

#include "evaluation/run_method.hpp"
#include "evaluation/simulated_sequence.hpp"

namespace stillmap {
namespace {

struct CalibrationErrors {
  double at_once, final;
};

CalibrationErrors errors(const std::string& scene, const std::string& sensor, const Parameters& parameters) {
  SimulationOptions options;
  options.scene = scene;
  options.sensor = sensor;
  options.seed = 91;
  options.scans = 30;
  SimulatedSequence sequence(options);
  const MethodResult result = run_method(sequence, choose_method("default", parameters), {}, [] {});
  return {result.at_once->probabilities().expected_calibration_error().value(),
          result.final.probabilities().expected_calibration_error().value()};
}

TEST(Calibration, HoldsOnOtherSeeds) {
  for (const auto& [scene, sensor] : {std::pair{"street", "vlp16"}, {"plaza", "os1_64"}, {"wood", "livox"}}) {
    const CalibrationErrors error = errors(scene, sensor, Parameters{});
    EXPECT_LE(error.at_once, 0.05) << scene << ", " << sensor;
    EXPECT_LE(error.final, 0.05) << scene << ", " << sensor;
    std::printf("  %s, %s: %.3f at once, %.3f final\n", scene, sensor, error.at_once, error.final);
  }
}

TEST(Calibration, OffItIsThePOfTheEquations) {
  Parameters parameters;
  parameters.calibrate_p_static = false;
  const CalibrationErrors error = errors("street", "vlp16", parameters);
  EXPECT_GT(error.at_once, 0.1);  // too cautious: most points stand, and new ones start at 0.5
}

}  // namespace
}  // namespace stillmap
