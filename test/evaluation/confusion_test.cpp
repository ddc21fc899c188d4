#include "evaluation/confusion.hpp"

#include <gtest/gtest.h>

#include "evaluation/probability_histogram.hpp"

namespace stillmap {
namespace {

void add(Confusion& counts, bool dynamic, Label verdict, int times) {
  for (int i = 0; i < times; ++i) counts.add(dynamic, verdict);
}

/// 10 static points: 7 static, 1 uncertain, 2 dynamic; 5 moving: 1 static, 1 invalid, 3 dynamic.
Confusion counted_by_hand() {
  Confusion counts;
  add(counts, false, Label::kStatic, 7);
  add(counts, false, Label::kUncertain, 1);
  add(counts, false, Label::kDynamic, 2);
  add(counts, true, Label::kStatic, 1);
  add(counts, true, Label::kInvalid, 1);
  add(counts, true, Label::kDynamic, 3);
  return counts;
}

TEST(Confusion, UncertainKept) {
  const Figures figures = counted_by_hand().figures(Uncertain::kKept);
  EXPECT_DOUBLE_EQ(*figures.pr, 80.0);
  EXPECT_DOUBLE_EQ(*figures.rr, 60.0);
  EXPECT_DOUBLE_EQ(*figures.score, 2 * 80.0 * 60.0 / 140.0);
  EXPECT_DOUBLE_EQ(*figures.aa, std::sqrt(80.0 * 60.0));
  EXPECT_DOUBLE_EQ(*figures.precision, 60.0);  // 3 of 5 removed
  EXPECT_DOUBLE_EQ(*figures.iou, 100.0 * 3 / (5 + 2));
}

TEST(Confusion, UncertainDropped) {
  const Figures figures = counted_by_hand().figures(Uncertain::kDropped);
  EXPECT_DOUBLE_EQ(*figures.pr, 70.0);
  EXPECT_DOUBLE_EQ(*figures.rr, 80.0);
  EXPECT_DOUBLE_EQ(*figures.precision, 100.0 * 4 / 7);
  EXPECT_DOUBLE_EQ(*figures.iou, 100.0 * 4 / (5 + 3));
}

TEST(Confusion, AnAbsentClassIsNotDefined) {
  Confusion no_dynamic;
  add(no_dynamic, false, Label::kStatic, 4);
  const Figures figures = no_dynamic.figures(Uncertain::kKept);
  EXPECT_DOUBLE_EQ(*figures.pr, 100.0);
  EXPECT_FALSE(figures.rr);
  EXPECT_FALSE(figures.score);
  EXPECT_FALSE(figures.aa);
  EXPECT_FALSE(figures.precision);
  EXPECT_FALSE(figures.iou);
  Confusion no_static;
  add(no_static, true, Label::kDynamic, 4);
  EXPECT_FALSE(no_static.figures(Uncertain::kKept).pr);
  EXPECT_DOUBLE_EQ(*no_static.figures(Uncertain::kKept).rr, 100.0);
  EXPECT_FALSE(no_static.figures(Uncertain::kKept).score);
  EXPECT_FALSE(Confusion().figures(Uncertain::kDropped).pr);
}

TEST(Confusion, NothingRightIsAScoreOfZero) {
  Confusion counts;
  add(counts, false, Label::kDynamic, 2);
  add(counts, true, Label::kStatic, 2);
  EXPECT_DOUBLE_EQ(*counts.figures(Uncertain::kKept).score, 0.0);
}

TEST(Confusion, Sums) {
  Confusion sum = counted_by_hand();
  sum += counted_by_hand();
  EXPECT_EQ(sum.static_points(), 20u);
  EXPECT_EQ(sum.dynamic_points(), 10u);
  EXPECT_DOUBLE_EQ(*sum.figures(Uncertain::kKept).pr, 80.0);
}

TEST(ProbabilityHistogram, ThresholdsAndCalibration) {
  ProbabilityHistogram histogram;
  for (int i = 0; i < 9; ++i) histogram.add(0.905F, false);
  histogram.add(0.905F, true);
  histogram.add(0.105F, true);
  histogram.add(std::nanf(""), true);  // never judged: left out
  EXPECT_DOUBLE_EQ(*histogram.pr_at(50), 100.0);
  EXPECT_DOUBLE_EQ(*histogram.rr_at(50), 50.0);
  EXPECT_DOUBLE_EQ(*histogram.pr_at(91), 0.0);
  EXPECT_DOUBLE_EQ(*histogram.rr_at(0), 0.0);
  const auto deciles = histogram.deciles();
  EXPECT_EQ(deciles[9].points, 10u);
  EXPECT_NEAR(deciles[9].mean_p_static, 0.905, 1e-6);
  EXPECT_DOUBLE_EQ(deciles[9].static_share, 0.9);
  EXPECT_NEAR(*histogram.expected_calibration_error(), (10 * 0.005 + 0.105) / 11, 1e-6);
}

TEST(ProbabilityHistogram, EmptyIsNotDefined) {
  const ProbabilityHistogram histogram;
  EXPECT_TRUE(histogram.empty());
  EXPECT_FALSE(histogram.pr_at(50));
  EXPECT_FALSE(histogram.expected_calibration_error());
}

}  // namespace
}  // namespace stillmap
