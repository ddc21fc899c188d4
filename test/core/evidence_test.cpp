// Equations (2) and (3): support, conflict, occlusion, unknown, and their fusion inside one scan.
#include "stillmap/evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stillmap {
namespace {

// Values that floats hold exactly, so that a boundary is a boundary: at 32 m, tau = 32 / 64 + 0.5 = 1 m.
constexpr LevelModel kLevel{/*epsilon_m=*/0.25F,
                            /*tau_0_m=*/0.5F,
                            /*alpha=*/0.015625F,
                            /*sigma_m=*/0.5F,
                            /*eta=*/0.8F,
                            /*kappa=*/1.2F,
                            /*eta_when_dynamic=*/0.1F,
                            ConflictStrength::kLinear};
constexpr float kRangeM = 32.0F;

Evidence at(float measured_m) {
  return classify(kRangeM, {measured_m, measured_m}, kLevel);
}
Evidence between(float nearest_m, float farthest_m) {
  return classify(kRangeM, {nearest_m, farthest_m}, kLevel);
}
float above(float value) {
  return std::nextafter(value, 1e9F);
}
float below(float value) {
  return std::nextafter(value, -1e9F);
}

TEST(ConflictThreshold, GrowsWithRange) {
  EXPECT_FLOAT_EQ(kLevel.tau_m(0), 0.5F);
  EXPECT_FLOAT_EQ(kLevel.tau_m(32), 1.0F);
  EXPECT_FLOAT_EQ(kLevel.tau_m(96), 2.0F);
}

TEST(Classify, FourCases) {
  EXPECT_EQ(at(32.0F), Evidence::kSupport);
  EXPECT_EQ(at(35.0F), Evidence::kConflict);
  EXPECT_EQ(at(20.0F), Evidence::kOcclusion);
  EXPECT_EQ(at(0.0F), Evidence::kUnknown);   // no return
  EXPECT_EQ(at(32.5F), Evidence::kUnknown);  // between epsilon and tau nothing is said
}

TEST(Classify, Boundaries) {
  EXPECT_EQ(at(32.25F), Evidence::kSupport);  // d = epsilon
  EXPECT_EQ(at(above(32.25F)), Evidence::kUnknown);
  EXPECT_EQ(at(33.0F), Evidence::kUnknown);  // d = tau
  EXPECT_EQ(at(above(33.0F)), Evidence::kConflict);
  EXPECT_EQ(at(31.75F), Evidence::kSupport);  // d = -epsilon
  EXPECT_EQ(at(below(31.75F)), Evidence::kOcclusion);
}

TEST(Classify, AConflictNeedsEveryBeamAroundToPass) {
  EXPECT_EQ(between(34.0F, 60.0F), Evidence::kConflict);
  EXPECT_EQ(between(33.0F, 60.0F), Evidence::kUnknown);
  EXPECT_EQ(between(32.0F, 60.0F), Evidence::kUnknown);  // a depth edge supports nothing
}

TEST(Classify, AnOcclusionNeedsEveryBeamAroundToBeStopped) {
  EXPECT_EQ(between(5.0F, 31.0F), Evidence::kOcclusion);
  EXPECT_EQ(between(5.0F, 31.75F), Evidence::kUnknown);
  EXPECT_EQ(between(5.0F, 60.0F), Evidence::kUnknown);
}

TEST(Classify, ASlantedSurfaceSupportsWhatLiesInItsSpan) {
  // One surface may span 2 epsilon + a tenth of the range: 0.5 + 3.2 m.
  EXPECT_EQ(between(30.0F, 33.6F), Evidence::kSupport);
  EXPECT_EQ(between(30.0F, 33.8F), Evidence::kUnknown);
}

void add(FusedEvidence& fused, float measured_m, const LevelModel& level) {
  const MeasuredRange measured{measured_m, measured_m};
  fused.add(classify(kRangeM, measured, level), kRangeM, measured, level);
}

TEST(FusedEvidence, NothingFromOcclusionAndUnknown) {
  FusedEvidence fused;
  add(fused, 0.0F, kLevel);
  add(fused, 20.0F, kLevel);
  EXPECT_EQ(fused.kind(), Evidence::kUnknown);
}

TEST(FusedEvidence, SupportIsEtaTimesOneMinusP) {
  FusedEvidence fused;
  add(fused, 32.0F, kLevel);
  EXPECT_EQ(fused.kind(), Evidence::kSupport);
  EXPECT_FLOAT_EQ(fused.increment(0.0F), 0.4F);             // 0.8 * 0.5
  EXPECT_NEAR(fused.increment(2.1972246F), 0.08F, 1e-6F);   // p = 0.9
  EXPECT_NEAR(fused.increment(-2.1972246F), 0.09F, 1e-6F);  // the rate while L < 0: 0.1 * 0.9
}

TEST(FusedEvidence, SupportAtSeveralLevelsIsOneAtTheLargestRate) {
  LevelModel weak = kLevel;
  weak.eta = 0.2F;
  FusedEvidence fused;
  add(fused, 32.0F, weak);
  add(fused, 32.0F, kLevel);
  add(fused, 32.0F, weak);
  EXPECT_FLOAT_EQ(fused.increment(0.0F), 0.4F);
}

TEST(FusedEvidence, ConflictAtOneLevelWinsOverSupportAtAllOthers) {
  FusedEvidence fused;
  add(fused, 32.0F, kLevel);
  add(fused, 33.25F, kLevel);  // d = 1.25: g = (1.25 - 1) / 0.5
  add(fused, 32.0F, kLevel);
  EXPECT_EQ(fused.kind(), Evidence::kConflict);
  EXPECT_FLOAT_EQ(fused.increment(0.0F), -0.6F);  // -1.2 * 0.5
  EXPECT_FLOAT_EQ(fused.increment(4.0F), -0.6F);  // whatever L is
}

TEST(FusedEvidence, TheStrongestConflictCountsOnce) {
  FusedEvidence fused;
  add(fused, 33.25F, kLevel);
  add(fused, 40.0F, kLevel);  // g = 1
  add(fused, 33.25F, kLevel);
  EXPECT_FLOAT_EQ(fused.increment(0.0F), -1.2F);
}

TEST(FusedEvidence, AConflictIsMeasuredToTheNearestBeamAround) {
  FusedEvidence fused;
  const MeasuredRange measured{33.25F, 80.0F};
  fused.add(classify(kRangeM, measured, kLevel), kRangeM, measured, kLevel);
  EXPECT_FLOAT_EQ(fused.increment(0.0F), -0.6F);
}

TEST(LevelModels, OneValueForAllLevelsOrOneForEach) {
  Parameters p;
  p.angular_levels_deg = {2.5, 2.0, 1.5};
  p.support_threshold_m_r = {0.3, 0.2, 0.1};
  p.conflict_rate_r = {1.5};
  p.conflict_strength = "sigmoid";
  const std::vector<LevelModel> models = level_models(p);
  ASSERT_EQ(models.size(), 3U);
  EXPECT_FLOAT_EQ(models[0].epsilon_m, 0.3F);
  EXPECT_FLOAT_EQ(models[2].epsilon_m, 0.1F);
  for (const LevelModel& model : models) {
    EXPECT_FLOAT_EQ(model.kappa, 1.5F);
    EXPECT_EQ(model.form, ConflictStrength::kSigmoid);
  }
}

}  // namespace
}  // namespace stillmap
