// Something stood there and is gone: its voxels must follow, and only those.
#include <gtest/gtest.h>

#include "simulation/path.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {
namespace {

/// A road between walls at 15 m.
World yard() {
  World world;
  world.add_ground(0, surfaces::kRoad);
  for (const double side : {-15.0, 15.0}) {
    add_wall(&world, {-40, side}, {40, side}, 0.3, 6, surfaces::kWall);
    add_wall(&world, {side * 2, -15}, {side * 2, 15}, 0.3, 6, surfaces::kWall);
  }
  return world;
}

/// A box that moves along the path; its x is the way it goes.
void add_moving_box(World* world, const Path& path, const SpeedProfile& profile,
                    const Eigen::Vector3d& size_m) {
  Mover box;
  box.body = {{make_box(pose_at(0, 0, size_m.z() / 2), size_m, surfaces::kMetal)}};
  box.motion = along(path, profile, world->ground);
  box.first_move_s = profile.first_move_s();
  world->add_mover(std::move(box));
}

TEST(ThingsThatLeave, ABoxIsClearedWithinAFewScans) {
  // It stands 8 m ahead for 2 s, then leaves to the side. After 2.7 s it has gone 1.2 m: from scan 27 on all
  // of its place is seen through. Near the ground, conflicts count little (conflict_beside_surface).
  World world = yard();
  add_moving_box(&world, Path({{8, 0}, {8, 14}}), SpeedProfile::starting(2, 5), {1, 1, 2});
  const Eigen::AlignedBox3d place = box({7.4, -0.6, 0.5}, {8.6, 0.6, 2.1});
  const Eigen::AlignedBox3d foot = box({7.4, -0.6, 0.2}, {8.6, 0.6, 0.5});
  struct Case {
    std::string sensor;
    double foot_static_max;
  };
  for (const auto& [sensor, foot_static_max] : {Case{"vlp16", 96}, Case{"os1_64", 5}}) {
    Mapper mapper{on_two_threads()};
    double static_before = 0;
    int cleared_at = 1000;
    RunOptions options{sensor, 50};
    options.after_scan = [&](int scan) {
      if (scan == 19) static_before = percent_of_voxels(mapper, place, Label::kStatic);
      if (scan >= 27 && percent_of_voxels(mapper, place, Label::kDynamic) >= 95)
        cleared_at = std::min(cleared_at, scan);
    };
    run(&mapper, world, standing_at(0, 0, 1.5), options);
    EXPECT_GE(measured(sensor + ": static while it stands, %", static_before), 88);      // 93 and 98.7
    EXPECT_LE(measured(sensor + ": scans until 95 % are dynamic", cleared_at - 26), 7);  // 5
    EXPECT_EQ(percent_of_voxels(mapper, place, Label::kStatic), 0);
    const double foot_static = percent_of_voxels(mapper, foot, Label::kStatic);  // 90 and 0
    EXPECT_LE(measured(sensor + ": foot still static, %", foot_static), foot_static_max);
  }
}

TEST(ThingsThatLeave, AParkedCarThatDrivesOffLeavesTheMap) {
  World world = yard();
  Random random(3);
  add_car(&world, Path({{9, 4}, {29, 4}}), SpeedProfile::starting(2, 6), &random);
  add_parked_car(&world, {9, -4}, 0, &random);
  const Eigen::AlignedBox3d place = box({6.6, 3, 0.35}, {11.4, 5, 1.6});
  const Eigen::AlignedBox3d other = box({6.6, -5, 0.35}, {11.4, -3, 1.6});
  Mapper mapper{on_two_threads()};
  const auto scans = run(&mapper, world, driving(1, 1.7), {"os1_64", 45});
  EXPECT_LT(measured("its place still static, %", percent_of_voxels(mapper, place, Label::kStatic)), 1);  // 0
  EXPECT_GT(measured("the car that stays, static, %", percent_of_voxels(mapper, other, Label::kStatic)),
            88);  // 92
  EXPECT_GT(measured("standing: static at once, %", percent(scans, 5, 20, of_class(kCar), Label::kStatic)),
            97);  // 99.6
  EXPECT_GT(measured("driving off: dynamic at once, %", percent(scans, 25, 45, is_moving, Label::kDynamic)),
            60);  // 66
}

TEST(ThingsThatLeave, CarsThatLeaveOneAfterAnother) {
  World world = yard();
  Random random(4);
  for (int car = 0; car < 3; ++car) {
    const double x = 4 + 7 * car;
    add_car(&world, Path({{x, 4}, {x, -3}, {-28, -3}}), SpeedProfile::starting(1 + car, 6), &random);
  }
  Mapper mapper{on_two_threads()};
  const auto scans = run(&mapper, world, standing_at(0, 0, 1.7), {"os1_64", 60});
  for (int car = 0; car < 3; ++car) {
    const Eigen::AlignedBox3d place = box({2.0 + 7 * car, 3.2, 0.35}, {6.0 + 7 * car, 4.8, 1.6});
    EXPECT_LT(measured("place still static, %", percent_of_voxels(mapper, place, Label::kStatic)), 1);  // 0
  }
  EXPECT_GT(measured("of what stands, kept, %", percent_kept(mapper, scans, is_standing)), 98);  // 98.7
}

TEST(ThingsThatLeave, AnOccludedVoxelIsUntouched) {
  // A box comes between the sensor and the wall at 1 s and stays: the wall behind keeps its log-odds, bit by
  // bit. No noise: the shadow's edge is sharp.
  World world = yard();
  add_moving_box(&world, Path({{6, -12}, {6, 0}}), SpeedProfile({{0, 12}, {1, 12}, {1.01, 0}}), {3, 1, 3});
  const RunOptions quiet{"vlp16", 15, ReturnNoise::none(), 0, 0, 0};
  Mapper early{on_two_threads()}, late{on_two_threads()};
  RunOptions longer = quiet;
  longer.scans = 45;
  run(&early, world, standing_at(0, 0, 1.5), quiet);
  run(&late, world, standing_at(0, 0, 1.5), longer);
  // Of the wall at 30 m, the shadow of +-1.5 m at 5.5 m reaches to +-8 m.
  const Eigen::AlignedBox3d shadow = box({29, -6, 0.5}, {31, 6, 6});
  const MapSnapshotPtr before = early.snapshot(), after = late.snapshot();
  std::size_t compared = 0, same = 0;
  for (std::size_t i = 0; i < before->voxels.size(); ++i) {
    if (!shadow.contains(before->voxels[i].center.cast<double>())) continue;
    ASSERT_EQ(after->voxels[i].center, before->voxels[i].center);
    same += after->voxels[i].log_odds == before->voxels[i].log_odds;
    ++compared;
  }
  EXPECT_EQ(same, compared);
  EXPECT_GT(compared, 50U);
}

}  // namespace
}  // namespace stillmap::simulation
