// Equation (9) at its two thresholds.
#include "stillmap/decision.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stillmap {
namespace {

const Decision kDecision{/*p_static_min=*/0.7F, /*p_dynamic_max=*/0.3F};

TEST(Decision, BothThresholdsBelongToTheVerdict) {
  EXPECT_EQ(kDecision(0.7F), Label::kStatic);
  EXPECT_EQ(kDecision(std::nextafter(0.7F, 0.0F)), Label::kUncertain);
  EXPECT_EQ(kDecision(0.3F), Label::kDynamic);
  EXPECT_EQ(kDecision(std::nextafter(0.3F, 1.0F)), Label::kUncertain);
}

TEST(Decision, WhatLiesBetweenIsDeferred) {
  EXPECT_EQ(kDecision(0.5F), Label::kUncertain);
  EXPECT_EQ(kDecision(1.0F), Label::kStatic);
  EXPECT_EQ(kDecision(0.0F), Label::kDynamic);
}

TEST(Types, EveryLabelAndReasonHasAName) {
  for (int label = 0; label <= static_cast<int>(Label::kInvalid); ++label)
    EXPECT_STRNE(to_string(static_cast<Label>(label)), "?");
  for (int reason = 0; reason < kReasonCount; ++reason)
    EXPECT_STRNE(to_string(static_cast<Reason>(reason)), "?");
}

TEST(Types, CountTellsTheLabelsApart) {
  ScanLabels labels;
  labels.label = {Label::kStatic,  Label::kDynamic,   Label::kStatic,
                  Label::kInvalid, Label::kUncertain, Label::kStatic};
  const LabelCounts counts = count(labels);
  EXPECT_EQ(counts.is_static, 3U);
  EXPECT_EQ(counts.dynamic, 1U);
  EXPECT_EQ(counts.uncertain, 1U);
  EXPECT_EQ(counts.invalid, 1U);
}

}  // namespace
}  // namespace stillmap
