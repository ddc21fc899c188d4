// What a caller may rely on: bad input is refused and leaves the map as it was, rows stay rows, reset
// forgets.
#include "stillmap/mapper.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/made_scans.hpp"
#include "stillmap/voxel_key.hpp"
#include "support/expect_error.hpp"

namespace stillmap {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Scan room() {
  return Rings{16, 720, -15, 15}.scan(ground_and_wall(1.5F, 12));
}

Eigen::Isometry3d at(double x_m) {
  return Eigen::Isometry3d(Eigen::Translation3d(x_m, 0, 1.5));
}

Mapper after_five_scans() {
  Mapper mapper{Parameters{}};
  for (int scan = 0; scan < 5; ++scan) mapper.process(room(), at(0));
  return mapper;
}

void expect_equal(const MapSnapshot& a, const MapSnapshot& b) {
  ASSERT_EQ(a.voxels.size(), b.voxels.size());
  for (std::size_t i = 0; i < a.voxels.size(); ++i) {
    ASSERT_EQ(a.voxels[i].center, b.voxels[i].center);
    ASSERT_EQ(a.voxels[i].log_odds, b.voxels[i].log_odds);
    ASSERT_EQ(a.voxels[i].label, b.voxels[i].label);
  }
}

TEST(Mapper, RefusesAPoseThatIsNotRigid) {
  Mapper mapper = after_five_scans();
  const MapSnapshotPtr before = mapper.snapshot();
  Eigen::Isometry3d not_finite = at(0), scaled = at(0), mirrored = at(0);
  not_finite.translation().x() = std::numeric_limits<double>::quiet_NaN();
  scaled.linear() *= 1.1;
  mirrored.linear()(0, 0) = -1;
  for (const Eigen::Isometry3d& pose : {not_finite, scaled, mirrored})
    expect_error<std::invalid_argument>([&] { mapper.process(room(), pose); }, {"T_map_sensor"});
  expect_equal(*mapper.snapshot(), *before);
  EXPECT_EQ(mapper.scan_count(), 5U);
}

TEST(Mapper, AnEmptyScanChangesNothing) {
  Mapper mapper = after_five_scans();
  const MapSnapshotPtr before = mapper.snapshot();
  const ScanLabels& labels = mapper.process(Scan{}, at(0));
  EXPECT_TRUE(labels.label.empty() && labels.p_static.empty() && labels.reason.empty());
  expect_equal(*mapper.snapshot(), *before);
}

TEST(Mapper, AnEmptyScanMayComeFirst) {
  Mapper mapper{Parameters{}};
  mapper.process(Scan{}, at(0));
  EXPECT_EQ(mapper.voxel_count(), 0U);
  EXPECT_TRUE(mapper.snapshot()->voxels.empty());
  mapper.process(room(), at(0));
  EXPECT_GT(mapper.voxel_count(), 1000U);
}

TEST(Mapper, RowsOfAnAllNaNScanAreInvalid) {
  Mapper mapper = after_five_scans();
  const MapSnapshotPtr before = mapper.snapshot();
  Scan scan;
  scan.points.assign(100, Eigen::Vector3f::Constant(kNaN));
  const ScanLabels& labels = mapper.process(scan, at(0));
  EXPECT_EQ(count(labels).invalid, 100U);
  for (const Reason reason : labels.reason) EXPECT_EQ(reason, Reason::kNoReturn);
  expect_equal(*mapper.snapshot(), *before);
}

TEST(Mapper, BadRowsKeepTheirPlace) {
  Mapper mapper{Parameters{}};
  Scan scan = room();
  const std::size_t good = scan.points.size();
  scan.points.insert(scan.points.begin(), Eigen::Vector3f(kNaN, 1, 1));
  scan.points.emplace_back(0, 0, 0);
  scan.points.emplace_back(0.1F, 0, 0);  // nearer than min_range_m
  scan.points.emplace_back(std::numeric_limits<float>::infinity(), 0, 0);
  scan.points.emplace_back(0, 5000, 0);
  const ScanLabels& labels = mapper.process(scan, at(0));
  ASSERT_EQ(labels.label.size(), good + 5);
  const Label expected[] = {Label::kInvalid, Label::kInvalid, Label::kInvalid, Label::kUncertain};
  EXPECT_EQ(labels.label.front(), Label::kInvalid);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(labels.label[1 + good + i], expected[i]) << i;
  EXPECT_EQ(labels.reason.back(), Reason::kOutOfRange);
  EXPECT_EQ(labels.p_static.back(), 0.5F);
  EXPECT_EQ(count(labels).invalid, 4U);
}

TEST(Mapper, WhatStandsBecomesStaticAndWhatVanishesDynamic) {
  Mapper mapper = after_five_scans();
  const Scan nearer = Rings{16, 720, -15, 15}.scan(ground_and_wall(1.5F, 8));
  const ScanLabels before = mapper.process(room(), at(0));
  EXPECT_EQ(count(before).is_static, room().points.size());
  const ScanLabels seen_through = mapper.process(nearer, at(0));  // a wall where scans saw through
  const LabelCounts counts = count(seen_through);
  EXPECT_GT(counts.dynamic, nearer.points.size() / 2);
}

TEST(Mapper, RelabelKeepsRowsThatWereNotJudged) {
  Mapper mapper{Parameters{}};
  Scan scan = room();
  scan.points.front() = {kNaN, 0, 0};
  scan.points.back() = {0, 5000, 0};
  const ScanLabels online = mapper.process(scan, at(0));
  for (int i = 0; i < 5; ++i) mapper.process(room(), at(0));
  const ScanLabels settled = mapper.relabel(scan, at(0), online);
  ASSERT_EQ(settled.label.size(), scan.points.size());
  EXPECT_EQ(settled.label.front(), Label::kInvalid);
  EXPECT_EQ(settled.label.back(), Label::kUncertain);
  EXPECT_EQ(settled.reason.back(), Reason::kOutOfRange);
  EXPECT_EQ(count(settled).is_static, scan.points.size() - 2);
}

TEST(Mapper, ResetForgetsEverything) {
  Mapper mapper = after_five_scans();
  mapper.reset();
  EXPECT_EQ(mapper.voxel_count(), 0U);
  EXPECT_EQ(mapper.scan_count(), 0U);
  for (int scan = 0; scan < 5; ++scan) mapper.process(room(), at(0));
  expect_equal(*mapper.snapshot(), *after_five_scans().snapshot());
}

TEST(Mapper, SnapshotListsBlocksOneByOneAndIsACopy) {
  Mapper mapper = after_five_scans();
  const MapSnapshotPtr snapshot = mapper.snapshot();
  ASSERT_EQ(snapshot->voxels.size(), mapper.voxel_count());
  const double inverse = 1 / snapshot->voxel_size_m;
  std::vector<std::uint64_t> blocks;
  int last_place = -1;
  for (const SnapshotVoxel& voxel : snapshot->voxels) {
    const VoxelKey key = voxel_key(voxel.center.cast<double>(), inverse);
    const std::uint64_t block = packed(block_key(key));
    if (blocks.empty() || blocks.back() != block) {
      blocks.push_back(block);
      last_place = -1;
    }
    EXPECT_GT(place_in_block(key), last_place);
    last_place = place_in_block(key);
  }
  std::sort(blocks.begin(), blocks.end());
  EXPECT_EQ(std::adjacent_find(blocks.begin(), blocks.end()), blocks.end()) << "a block comes once";
  mapper.reset();
  EXPECT_GT(snapshot->voxels.size(), 1000U);
}

TEST(Mapper, StampOfTheSnapshotIsTheNewestScans) {
  Mapper mapper{Parameters{}};
  Scan scan = room();
  scan.stamp_ns = 123'456'789'012;
  mapper.process(scan, at(0));
  EXPECT_EQ(mapper.snapshot()->stamp_ns, 123'456'789'012);
}

TEST(Mapper, ListenerHearsEachStageOnceInOrder) {
  struct Listener : StageListener {
    std::vector<Stage> heard;
    void stage_ended(Stage stage) override { heard.push_back(stage); }
  } listener;
  Mapper mapper{Parameters{}};
  mapper.set_listener(&listener);
  mapper.process(room(), at(0));
  mapper.reset();
  mapper.process(room(), at(0));
  ASSERT_EQ(listener.heard.size(), 2U * kStageCount);
  for (std::size_t i = 0; i < listener.heard.size(); ++i)
    EXPECT_EQ(static_cast<int>(listener.heard[i]), static_cast<int>(i) % kStageCount);
}

TEST(Mapper, FarFromTheOriginItSeesTheSame) {
  // The map's origin may be kilometres away: coordinates are in double until they are near the sensor. 4096 m
  // is a whole number of voxels of 0.125 m, so that the same voxels are hit.
  Parameters p;
  p.voxel_size_m = 0.125;
  Mapper near{p}, far{p};
  for (int scan = 0; scan < 5; ++scan) {
    const ScanLabels a = near.process(room(), at(0.3 * scan)), b = far.process(room(), at(4096 + 0.3 * scan));
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.label.size(); ++i) same += a.label[i] == b.label[i];
    EXPECT_GE(static_cast<double>(same), 0.999 * static_cast<double>(a.label.size()));
  }
}

TEST(Mapper, OtherThresholdsChangeTheDecisionNotTheMap) {
  Mapper mapper = after_five_scans(), other = after_five_scans();
  expect_error<std::invalid_argument>([&] { mapper.set_decision(0.2, 0.1); }, {"p_static_min"});
  mapper.set_decision(1.0, 0.3);
  const MapSnapshotPtr strict = mapper.snapshot();
  EXPECT_FALSE(strict->voxels.empty());
  for (const SnapshotVoxel& voxel : strict->voxels) ASSERT_NE(voxel.label, Label::kStatic);
  // Fewer, not none: what belongs to known surface follows it.
  EXPECT_LT(count(mapper.process(room(), at(0))).is_static, count(other.process(room(), at(0))).is_static);
  mapper.set_decision(other.decision().p_static_min, other.decision().p_dynamic_max);
  expect_equal(*mapper.snapshot(), *other.snapshot());
}

}  // namespace
}  // namespace stillmap
