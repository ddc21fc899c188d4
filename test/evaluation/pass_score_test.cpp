#include "evaluation/pass_score.hpp"

#include <gtest/gtest.h>

#include "evaluation/map_wise.hpp"
#include "support/expect_error.hpp"

namespace stillmap {
namespace {

constexpr std::uint32_t kRoad = 40, kPlant = 70, kWalker = 254 | 7u << 16, kCyclist = 253 | 8u << 16;

/// A scan whose points lie at these ranges.
Frame frame_of(const std::vector<float>& ranges_m) {
  Frame frame;
  frame.name = "000003";
  for (const float range_m : ranges_m) frame.scan.points.emplace_back(range_m, 0, 0);
  return frame;
}

const Label S = Label::kStatic, U = Label::kUncertain, D = Label::kDynamic;

TEST(PassScore, CountsByClassAndRangeAndIgnoresWhatHasNoTruth) {
  PassScore pass;
  pass.add(frame_of({5, 9, 15, 35, 60, 5}), {kRoad, kPlant, kPlant, kWalker, kWalker, 1},
           {{S, U, D, D, S, D}, {}});
  EXPECT_EQ(pass.total().points(), 5u);
  EXPECT_DOUBLE_EQ(*pass.total().figures(Uncertain::kKept).pr, 100.0 * 2 / 3);
  EXPECT_DOUBLE_EQ(*pass.vegetation_kept(Uncertain::kKept), 50.0);
  EXPECT_DOUBLE_EQ(*pass.vegetation_kept(Uncertain::kDropped), 0.0);
  EXPECT_EQ(pass.classes().size(), 3u);
  EXPECT_DOUBLE_EQ(*pass.classes().at(254).figures(Uncertain::kKept).rr, 50.0);
  EXPECT_FALSE(pass.classes().at(254).figures(Uncertain::kKept).pr);
  EXPECT_EQ(pass.ranges()[0].points(), 2u);
  EXPECT_EQ(pass.ranges()[1].points(), 1u);
  EXPECT_DOUBLE_EQ(*pass.ranges()[2].figures(Uncertain::kKept).rr, 100.0);
  EXPECT_DOUBLE_EQ(*pass.ranges()[3].figures(Uncertain::kKept).rr, 0.0);
  EXPECT_TRUE(pass.probabilities().empty());
}

TEST(PassScore, WithoutVegetationItsFigureIsNotDefined) {
  PassScore pass;
  pass.add(frame_of({5}), {kRoad}, {{S}, {}});
  EXPECT_FALSE(pass.vegetation_kept(Uncertain::kKept));
}

TEST(PassScore, DelayUntilHalfOfAnObjectIsFlagged) {
  PassScore pass;
  const Frame two = frame_of({5, 6});
  pass.add(frame_of({5}), {kRoad}, {{S}, {}});
  pass.add(two, {kWalker, kWalker}, {{S, S}, {}});
  pass.add(two, {kWalker, kWalker}, {{U, S}, {}});
  pass.add(two, {kWalker, kCyclist}, {{S, S}, {}});
  pass.add(two, {kWalker, kWalker}, {{D, S}, {}});  // half of it: 3 scans after the first
  const ObjectScore& walker = pass.objects().at(kWalker);
  EXPECT_EQ(walker.points, 7u);
  EXPECT_EQ(walker.removed, 1u);
  EXPECT_EQ(walker.first_scan, 1u);
  EXPECT_EQ(walker.delay_scans(), 3u);
  EXPECT_FALSE(pass.objects().at(kCyclist).delay_scans());
  const DelaySummary delay = pass.delay();
  EXPECT_EQ(delay.objects, 2u);
  EXPECT_EQ(delay.never, 1u);
  EXPECT_FALSE(delay.median_scans);  // of 3 and never
}

TEST(PassScore, ObjectsOfTheFirstScanHaveNoDelay) {
  PassScore pass;
  pass.add(frame_of({5}), {kWalker}, {{D}, {}});
  pass.add(frame_of({5}), {kCyclist}, {{D}, {}});
  EXPECT_EQ(pass.delay().objects, 1u);
  EXPECT_DOUBLE_EQ(*pass.delay().median_scans, 0.0);
}

TEST(PassScore, RefusesAnotherCountOfLabels) {
  PassScore pass;
  expect_error(
      [&] {
        pass.add(frame_of({1, 2}), {kRoad}, {{S, S}, {}});
      },
      {"000003", "1 labels for 2 points"});
  expect_error([&] { pass.add(frame_of({1, 2}), {kRoad, kRoad}, {{S}, {}}); }, {"1 verdicts for 2 points"});
}

TEST(MapWise, ARemovedPointNearAKeptOneIsRetained) {
  MapWiseCount count(0.1);
  count.add_removed({1, 1, 1}, false);
  count.add_removed({2, 2, 2}, true);
  count.add_removed({3, 3, 3}, true);
  count.add_to_map({1.03, 1.03, 1});         // 4.2 cm away
  count.add_to_map({2.0, 2.0, 2.0 + 0.06});  // 6 cm away
  count.add_to_map({3.0, 3.0, 2.96});        // a point without truth is of the map, too
  count.count_kept(false);
  const Figures figures = count.counts().figures(Uncertain::kKept);
  EXPECT_DOUBLE_EQ(*figures.pr, 100.0);
  EXPECT_DOUBLE_EQ(*figures.rr, 50.0);
}

}  // namespace
}  // namespace stillmap
