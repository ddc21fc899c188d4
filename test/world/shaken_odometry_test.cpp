// Poses that jump from scan to scan: much less of what stands is eaten, and what moves is found as before.
#include <gtest/gtest.h>

#include "core/scan_alignment.hpp"
#include "simulation/path.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {
namespace {

/// A yard between walls, with poles and with people who walk about.
World yard() {
  World world;
  world.ground.slope = {0.02, -0.01};
  world.add_ground(0, surfaces::kRoad);
  add_wall(&world, {-30, 12}, {50, 12}, 0.3, 5, surfaces::kWall);
  add_wall(&world, {-30, -15}, {50, -15}, 0.3, 5, surfaces::kWall);
  add_wall(&world, {30, -15}, {30, 12}, 0.3, 5, surfaces::kWall);
  for (double x = -10; x < 30; x += 8) add_pole(&world, {x, 9}, 0.12, 5);
  Random random(21);
  for (int person = 0; person < 6; ++person) {
    const double x = 3 + 3 * person, y = person % 2 == 0 ? 6 : -4;
    add_person(&world, Path({{x, y}, {x, -y}}), SpeedProfile::constant(1.2), &random);
  }
  return world;
}

RunOptions shaken(double noise_m, double noise_deg, double drift_percent) {
  RunOptions options;
  options.sensor = "os1_64";
  options.scans = 30;
  options.pose_noise_m = noise_m;
  options.pose_noise_deg = noise_deg;
  options.drift_percent = drift_percent;
  return options;
}

struct Shares {
  double eaten, found;
};
Shares shares(bool align_scans, const RunOptions& options) {
  Parameters parameters = on_two_threads();
  parameters.align_scans = align_scans;
  Mapper mapper(parameters);
  const auto scans = run(&mapper, yard(), driving(2, 1.2), options);
  return {percent(scans, 5, scans.size(), is_standing, Label::kDynamic),
          percent(scans, 5, scans.size(), is_moving, Label::kDynamic)};
}

TEST(ShakenOdometry, EatsLess) {
  const RunOptions options = shaken(0.03, 0.4, 0);
  const Shares aligned = shares(true, options), as_given = shares(false, options);
  EXPECT_GE(measured("movers found, %", aligned.found), 95);                                 // 99.9
  EXPECT_GE(measured("standing things dynamic with poses as given, %", as_given.eaten), 5);  // 6.6
  EXPECT_LE(measured("standing things dynamic, %", aligned.eaten), 0.6 * as_given.eaten);    // 3.1
}

TEST(ShakenOdometry, SteadyOneIsTakenAsItIs) {
  const RunOptions options = shaken(0.01, 0.03, 0.5);
  const Shares aligned = shares(true, options), as_given = shares(false, options);
  EXPECT_EQ(aligned.eaten, as_given.eaten);
  EXPECT_EQ(aligned.found, as_given.found);
}

TEST(ScanAlignment, FindsHowFarAPoseIsOff) {
  Mapper mapper{on_two_threads()};
  const auto scans = run(&mapper, yard(), driving(2, 1.2), shaken(0, 0, 0));
  VoxelMap map(mapper.parameters().voxel_size_m);
  for (const BlockContents& block : mapper.export_map().blocks) map.restore(block, 0);
  const Frame& frame = scans.back().truth.frame;
  ProjectedScan projected;
  project(frame.scan, 0.4F, 100.0F, projected);
  const SmallMotion given{{0.008, -0.005, 0.006}, {0.05, -0.06, 0.04}};
  const auto found = ScanAlignment(map).find(projected, given.applied_to(frame.T_map_sensor));
  ASSERT_TRUE(found);
  EXPECT_LE(measured("turn, rad", (found->turn_rad + given.turn_rad).norm()), 0.001);
  EXPECT_LE(measured("shift, m", (found->shift_m + given.shift_m).norm()), 0.02);
  const VoxelMap nothing(0.1);
  EXPECT_FALSE(ScanAlignment(nothing).find(projected, frame.T_map_sensor));
}

}  // namespace
}  // namespace stillmap::simulation
