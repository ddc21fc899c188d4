// A robot drives around a building and comes back 1 m beside where it is: the walls there are in the map
// twice. The corrected trajectory must leave one of them.
#include <gtest/gtest.h>
#include <tsl/robin_set.h>

#include <chrono>

#include "stillmap/voxel_key.hpp"
#include "support/expect_error.hpp"
#include "world/drifting_drive.hpp"

namespace stillmap::simulation {
namespace {

Parameters with_submaps() {
  Parameters parameters = on_two_threads();
  parameters.submap_length_m = 5;
  return parameters;
}

/// Percent of the static voxels above the ground that have no static voxel of the other map within 0.3 m.
double percent_alone(const Mapper& mapper, const Mapper& other) {
  const MapSnapshotPtr map = mapper.snapshot(), reference = other.snapshot();
  tsl::robin_set<std::uint64_t, BlockKeyHash> known;
  const auto key_of = [&](const SnapshotVoxel& voxel) {
    return voxel_key(voxel.center.cast<double>(), 1 / map->voxel_size_m);
  };
  for (const SnapshotVoxel& voxel : reference->voxels)
    if (voxel.label == Label::kStatic) known.insert(packed(key_of(voxel)));
  std::size_t alone = 0, all = 0;
  for (const SnapshotVoxel& voxel : map->voxels) {
    if (voxel.label != Label::kStatic || voxel.center.z() < 0.3F) continue;
    bool found = false;
    for (int i = 0; i < 343 && !found; ++i)
      found = known.count(packed(key_of(voxel) + VoxelKey(i % 7 - 3, i / 7 % 7 - 3, i / 49 - 3))) > 0;
    alone += !found;
    ++all;
  }
  return 100.0 * static_cast<double>(alone) / static_cast<double>(all);
}

struct LoopClosureTest : testing::Test {
  static const Drive& drive() {
    static const Drive drive;
    return drive;
  }
  static const Mapper& truth() {
    static const Mapper truth = drive().mapped(on_two_threads(), true);
    return truth;
  }
};

TEST_F(LoopClosureTest, ACorrectedPathTakesTheDoubleWallAway) {
  Mapper mapper = drive().mapped(with_submaps(), false);
  EXPECT_GT(measured("wrong before, %", percent_alone(mapper, truth())), 15);
  const auto start = std::chrono::steady_clock::now();
  const TrajectoryCorrection done = mapper.correct_trajectory(drive().corrected_path());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  measured("correction, s", took.count());
  EXPECT_TRUE(done.applied);
  EXPECT_GT(done.submaps, 10U);
  EXPECT_NEAR(done.largest_m, 1.0, 0.3);
  EXPECT_LT(measured("wrong after, %", percent_alone(mapper, truth())), 1);
  EXPECT_LT(measured("lost, %", percent_alone(truth(), mapper)), 3);

  // Scans go on in the corrected frame, and the same path once more moves nothing.
  const SimulatedFrame& last = drive().frames.back();
  Scan next = last.frame.scan;
  next.stamp_ns += 100'000'000;
  const LabelCounts counts = count(mapper.process(next, last.T_map_sensor_true));
  EXPECT_GT(measured("of the next scan static, %", 100.0 * counts.is_static / next.points.size()), 95);
  EXPECT_FALSE(mapper.correct_trajectory(drive().corrected_path()).applied);
}

/// Scans that see 8 m far: the other side of the yard is closed away when the loop is closed.
TEST_F(LoopClosureTest, WhatIsFarFollowsToo) {
  Parameters near = with_submaps(), plain = on_two_threads();
  near.max_range_m = plain.max_range_m = 8;
  Mapper mapper = drive().mapped(near, false);
  const Mapper right = drive().mapped(plain, true);
  EXPECT_GT(measured("far: wrong before, %", percent_alone(mapper, right)), 15);
  EXPECT_TRUE(mapper.correct_trajectory(drive().corrected_path()).applied);
  EXPECT_LT(measured("far: wrong after, %", percent_alone(mapper, right)), 1);
  EXPECT_LT(measured("far: lost, %", percent_alone(right, mapper)), 3);
  EXPECT_EQ(mapper.voxel_count(), mapper.snapshot()->voxels.size());

  // The tiles go their way again.
  const SimulatedFrame& last = drive().frames.back();
  for (int k = 1; k < 40; ++k) {
    Scan next = last.frame.scan;
    next.stamp_ns += std::int64_t{100'000'000} * k;
    mapper.process(next, last.T_map_sensor_true);
  }
  EXPECT_EQ(mapper.voxel_count(), mapper.snapshot()->voxels.size());
  EXPECT_LT(measured("far: lost later, %", percent_alone(right, mapper)), 3);
}

TEST_F(LoopClosureTest, AJumpOfTheNewestPoseIsSpreadOverTheWay) {
  Mapper mapper = drive().mapped(with_submaps(), false);
  const SimulatedFrame& last = drive().frames.back();
  const TrajectoryCorrection done =
      mapper.correct_newest_pose(last.T_map_sensor_true * last.frame.T_map_sensor.inverse());
  EXPECT_TRUE(done.applied);
  EXPECT_LT(measured("wrong after a jump, %", percent_alone(mapper, truth())), 2);
}

TEST_F(LoopClosureTest, KeepingSubmapsChangesNoLabel) {
  Mapper with(with_submaps()), without{on_two_threads()};
  for (int k = 0; k < 30; ++k) {
    const Frame& frame = drive().frames[static_cast<std::size_t>(k)].frame;
    EXPECT_EQ(with.process(frame.scan, frame.T_map_sensor).label,
              without.process(frame.scan, frame.T_map_sensor).label);
  }
}

TEST_F(LoopClosureTest, RefusesWhatDoesNotFitAndKeepsTheMap) {
  Mapper mapper = drive().mapped(with_submaps(), false);
  const std::size_t voxels = mapper.voxel_count();
  std::vector<StampedPose> foreign = drive().corrected_path();
  for (StampedPose& pose : foreign) pose.stamp_ns += 1'000'000'000'000;
  const auto refused = [&] { mapper.correct_trajectory(foreign); };
  expect_error<std::invalid_argument>(refused,
                                      {"none of them", "1000.000 to 1014.500 s", "0.000 to 14.900 s"});
  EXPECT_EQ(mapper.voxel_count(), voxels);
  Mapper without{on_two_threads()};
  expect_error<std::invalid_argument>([&] { without.correct_trajectory(drive().corrected_path()); },
                                      {"submap_length_m"});
}

TEST_F(LoopClosureTest, AnImportedMapStaysInItsPlace) {
  Mapper mapper(with_submaps());
  mapper.import_map(truth().export_map());
  const Frame& first = drive().frames.front().frame;
  mapper.process(first.scan, first.T_map_sensor);
  Eigen::Isometry3d aside = Eigen::Isometry3d::Identity();
  aside.translation().x() = 1;
  EXPECT_TRUE(mapper.correct_newest_pose(aside).applied);
  EXPECT_LT(measured("of the imported map lost, %", percent_alone(truth(), mapper)), 1);
}

}  // namespace
}  // namespace stillmap::simulation
