// Movers that are hard to tell: those whose place was never seen empty, and those who pause.
#include <gtest/gtest.h>

#include "simulation/path.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {
namespace {

World road_between_houses(double length_m) {
  World world;
  world.add_ground(0, surfaces::kRoad);
  Random random(31);
  for (const int side : {-1, 1})
    for (double x = -30; x < length_m; x += 14) add_house(&world, {x, side * 9.0}, 12, 8, 7, side, &random);
  return world;
}

World corridor(double length_m) {
  World world;
  world.add_ground(0, surfaces::kFloor);
  for (const double y : {-1.5, 1.5}) add_wall(&world, {-3, y}, {length_m, y}, 0.2, 3, surfaces::kWall);
  for (const double x : {-3.0, length_m}) add_wall(&world, {x, -1.5}, {x, 1.5}, 0.2, 3, surfaces::kWall);
  return world;
}

/// Index of the first scan from `from` on that labels at least half of what moves dynamic.
int first_flagged(const std::vector<JudgedScan>& scans, int from) {
  for (int k = from; k < static_cast<int>(scans.size()); ++k)
    if (percent(scans[static_cast<std::size_t>(k)], is_moving, Label::kDynamic) >= 50) return k;
  return 1000;
}

double flagged(const std::vector<JudgedScan>& scans, std::size_t from, std::size_t to) {
  return percent(scans, from, to, is_moving, Label::kDynamic);
}

const std::string kSensors[] = {"vlp16",
                                "os1_64"};  // what is measured stands beside the bounds, in this order

TEST(HardMovers, ACarAheadAtTheSensorsOwnSpeed) {
  World world = road_between_houses(100);
  Random random(32);
  add_car(&world, Path({{12, 0}, {120, 0}}), SpeedProfile::constant(8), &random);
  struct Case {
    std::string sensor;
    double flagged_min, static_max;
  };
  for (const auto& [sensor, flagged_min, static_max] :
       {Case{"vlp16", 90, 7}, Case{"os1_64", 95, 3}, Case{"mid360", 55, 37}}) {  // 92.6, 98.7, 59.7 flagged
    const auto scans = run(world, driving(8, 1.7), {sensor, 50});
    EXPECT_LE(measured(sensor + ": scans until half of it is flagged", first_flagged(scans, 0)), 3);
    EXPECT_GE(measured(sensor + ": then flagged, %", flagged(scans, 10, 50)), flagged_min);
    EXPECT_LE(measured(sensor + ": static, %", percent(scans, 10, 50, is_moving, Label::kStatic)),
              static_max);
  }
}

TEST(HardMovers, SomeoneAheadIndoorsAtTheSensorsPace) {
  World world = corridor(14);
  Random random(33);
  add_person(&world, Path({{2.5, 0}, {30, 0}}), SpeedProfile::constant(0.8), &random);
  for (const std::string& sensor : kSensors) {
    const auto scans = run(world, driving(0.8, 1.0), {sensor, 80});
    EXPECT_LE(measured(sensor + ": scans until half is flagged", first_flagged(scans, 0)), 6);  // 4, 4
    EXPECT_GE(measured(sensor + ": then flagged, %", flagged(scans, 15, 80)), 96);              // 100, 100
    const double walls_dynamic = percent(scans, 0, 80, is_standing, Label::kDynamic);
    EXPECT_LE(measured(sensor + ": walls dynamic, %", walls_dynamic), 0.1);  // 0.00
  }
}

TEST(HardMovers, SomeoneWhoStandsThenWalks) {
  World world = road_between_houses(60);
  Random random(34);
  add_person(&world, Path({{8, 2}, {8, -8}}), SpeedProfile::starting(3, 1.3), &random);
  for (const std::string& sensor : kSensors) {
    const auto scans = run(world, driving(0.5, 1.5), {sensor, 60});
    const double while_standing = percent(scans, 0, 30, of_class(kPerson), Label::kDynamic);
    EXPECT_LE(measured(sensor + ": dynamic while standing, %", while_standing), 1);  // 0
    const int delay = first_flagged(scans, 31) - 30;
    EXPECT_LE(measured(sensor + ": scans until half is flagged", delay), 8);        // 6, 6
    EXPECT_GE(measured(sensor + ": then flagged, %", flagged(scans, 45, 60)), 94);  // 98
  }
}

TEST(HardMovers, SomeoneWhoStops) {
  // Walks for 3 s, then stands: he must not be taken into the static map soon.
  World world = road_between_houses(60);
  Random random(35);
  add_person(&world, Path({{8, 4}, {8, -8}}), SpeedProfile::stopping(3, 1.3), &random);
  for (const std::string& sensor : kSensors) {
    const auto scans = run(world, standing_at(0, 0, 1.5), {sensor, 60});
    EXPECT_GE(measured(sensor + ": walking, flagged, %", flagged(scans, 5, 28)), 90);  // 94, 99
    const double first_second = percent(scans, 30, 40, is_moving, Label::kStatic);
    EXPECT_LE(measured(sensor + ": first second of standing, static, %", first_second), 18);  // 11, 5
    const double third_second = percent(scans, 50, 60, is_moving, Label::kStatic);
    EXPECT_LE(measured(sensor + ": third second of standing, static, %", third_second), 30);  // 22, 12
  }
}

/// Percent of the parked car's returns that are static in the map, by the time it has stood.
struct Settling {
  double after_45_s = 0, after_75_s = 0;
};

Settling settling_of_a_car_that_parks(const std::string& sensor, const Parameters& parameters) {
  constexpr double kDrivesS = 2.5, kRateHz = 4;
  World world = road_between_houses(60);
  Random random(37);
  add_car(&world, Path({{-12, 4}, {30, 4}}), SpeedProfile::stopping(kDrivesS, 8), &random);
  Mapper mapper{parameters};
  RunOptions options{sensor, static_cast<int>((kDrivesS + 76) * kRateHz)};
  options.scan_rate_hz = kRateHz;
  const auto scans = run(&mapper, world, standing_at(0, 0, 1.7), options);
  const auto is_static = [&](double stood_s) {
    const auto scan = static_cast<std::size_t>((kDrivesS + stood_s) * kRateHz);
    return percent(scans[scan], is_moving, Label::kStatic);
  };
  return {is_static(45), is_static(75)};
}

TEST(HardMovers, SomeoneWhoComesCloserAndStops) {
  World world = road_between_houses(60);
  Random random(36);
  add_person(&world, Path({{12, 0.3}, {1, 0.3}}), SpeedProfile::stopping(5, 1.2), &random);
  const auto flagged_after_he_stopped = [&](bool remember_arrivals) {
    Parameters parameters = on_two_threads();
    parameters.remember_arrivals = remember_arrivals;
    Mapper mapper(parameters);
    return flagged(run(&mapper, world, standing_at(0, 0, 1.2), {"vlp16", 90}), 55, 85);
  };
  EXPECT_GE(measured("flagged in the 3 s after he stopped, %", flagged_after_he_stopped(true)), 97);  // 99.9
  EXPECT_LE(measured("his arrival forgotten, %", flagged_after_he_stopped(false)), 95);               // 91.3
}

TEST(HardMovers, ACarThatParksSettlesAfterItsTime) {
  const Settling by_default = settling_of_a_car_that_parks("vlp16", on_two_threads());
  EXPECT_LE(measured("static after 45 s, %", by_default.after_45_s), 10);
  EXPECT_GE(measured("static after 75 s, %", by_default.after_75_s), 90);
  Parameters patient = on_two_threads();
  patient.settle_time_s = 150;
  const Settling later = settling_of_a_car_that_parks("vlp16", patient);
  EXPECT_LE(measured("settle_time_s 150: static after 75 s, %", later.after_75_s), 10);
}

TEST(HardMovers, ADoorThatOpens) {
  World world = corridor(8);
  add_door(&world, {5, -0.5}, M_PI / 2, 1.4, 2, 1.0, 2.1);
  Mapper mapper{on_two_threads()};
  const auto scans = run(&mapper, world, standing_at(0, 0, 1.2), {"os1_64", 60});
  const double closed = percent(scans, 0, 19, is_standing, Label::kDynamic);
  EXPECT_LE(measured("closed: dynamic, %", closed), 0.1);                  // 0
  EXPECT_GE(measured("opening: flagged, %", flagged(scans, 24, 40)), 42);  // 48
  const Eigen::AlignedBox3d doorway = box({4.8, -0.3, 0.3}, {5.2, 0.4, 1.9});
  EXPECT_LE(measured("doorway still static, %", percent_of_voxels(mapper, doorway, Label::kStatic)), 1);  // 0
}

TEST(HardMovers, FeetAndTheGroundTheyWalkOn) {
  World world = road_between_houses(60);
  Random random(36);
  for (int person = 0; person < 5; ++person) {
    const double x = 4 + 2 * person;
    add_person(&world, Path({{x, 6}, {x, -8}}), SpeedProfile::constant(1.2), &random);
  }
  Mapper mapper{on_two_threads()};
  const auto scans = run(&mapper, world, standing_at(0, 0, 1.2), {"os1_64", 50});
  EXPECT_GE(measured("people flagged at once, %", flagged(scans, 10, 50)), 93);                 // 97.0
  EXPECT_LE(measured("people left in the end, %", percent_kept(mapper, scans, is_moving)), 4);  // 2.2
  const double ground_kept = percent_kept(mapper, scans, of_class(surfaces::kRoad.semantic_class));
  EXPECT_GE(measured("ground kept, %", ground_kept), 99.8);  // 99.97
}

}  // namespace
}  // namespace stillmap::simulation
