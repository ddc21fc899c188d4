// Equations (1) and (4) to (8). The numbers on the right are worked out by hand.
#include "stillmap/log_odds.hpp"

#include <gtest/gtest.h>

namespace stillmap {
namespace {

constexpr float kStep = 1e-6F;

TEST(LogOdds, OfAProbability) {
  EXPECT_FLOAT_EQ(log_odds_from_p(0.5F), 0.0F);
  EXPECT_NEAR(log_odds_from_p(0.7F), 0.8472979F, kStep);   // ln(7 / 3)
  EXPECT_NEAR(log_odds_from_p(0.3F), -0.8472979F, kStep);  // ln(3 / 7)
  EXPECT_NEAR(log_odds_from_p(0.9F), 2.1972246F, kStep);   // ln 9
}

TEST(LogOdds, ToAProbability) {
  EXPECT_FLOAT_EQ(p_from_log_odds(0.0F), 0.5F);
  EXPECT_NEAR(p_from_log_odds(4.0F), 0.9820138F, kStep);   // 1 / (1 + e^-4)
  EXPECT_NEAR(p_from_log_odds(-4.0F), 0.0179862F, kStep);  // 1 / (1 + e^4)
  for (float p = 0.02F; p < 0.99F; p += 0.01F) EXPECT_NEAR(p_from_log_odds(log_odds_from_p(p)), p, kStep);
}

TEST(ConflictStrength, LinearGrowsOverSigmaAndStopsAtOne) {
  const auto g = [](float d_m) { return conflict_strength(ConflictStrength::kLinear, d_m, 0.5F, 0.25F); };
  EXPECT_FLOAT_EQ(g(0.5F), 0.0F);
  EXPECT_FLOAT_EQ(g(0.625F), 0.5F);  // (0.625 - 0.5) / 0.25
  EXPECT_FLOAT_EQ(g(0.75F), 1.0F);
  EXPECT_FLOAT_EQ(g(30.0F), 1.0F);
}

TEST(ConflictStrength, SigmoidIsHalfInTheMiddleOfSigma) {
  const auto g = [](float d_m) { return conflict_strength(ConflictStrength::kSigmoid, d_m, 0.5F, 0.25F); };
  EXPECT_NEAR(g(0.5F), 0.0179862F, kStep);  // 1 / (1 + e^4)
  EXPECT_FLOAT_EQ(g(0.625F), 0.5F);
  EXPECT_NEAR(g(0.75F), 0.9820138F, kStep);  // 1 / (1 + e^-4)
  for (float d_m = 0.5F; d_m < 2.0F; d_m += 0.01F) {
    EXPECT_LE(g(d_m), g(d_m + 0.01F));
    EXPECT_LE(g(d_m), 1.0F);
  }
}

TEST(Increment, SupportSaturatesWithP) {
  EXPECT_FLOAT_EQ(support_increment(0.8F, 0.5F), 0.4F);
  EXPECT_FLOAT_EQ(support_increment(0.8F, 0.875F), 0.1F);
  EXPECT_FLOAT_EQ(support_increment(0.8F, 1.0F), 0.0F);
}

TEST(Increment, ConflictTakesKappaTimesG) {
  EXPECT_FLOAT_EQ(conflict_increment(1.2F, 0.5F), -0.6F);
  EXPECT_FLOAT_EQ(conflict_increment(1.2F, 1.0F), -1.2F);
}

const Recursion kRecursion{/*increment_clip=*/1.5F, /*forgetting=*/0.01F, /*min=*/-3.0F, /*max=*/4.0F};

TEST(Recursion, ForgetsThenAdds) {
  EXPECT_FLOAT_EQ(kRecursion(0.0F, 0.4F), 0.4F);
  EXPECT_FLOAT_EQ(kRecursion(2.0F, 0.3F), 2.28F);    // 0.99 * 2 + 0.3
  EXPECT_FLOAT_EQ(kRecursion(-2.0F, 0.3F), -1.68F);  // 0.99 * -2 + 0.3
  EXPECT_FLOAT_EQ(kRecursion(2.0F, 0.0F), 1.98F);
}

TEST(Recursion, ClipsTheIncrementOfOneScan) {
  EXPECT_FLOAT_EQ(kRecursion(2.0F, -5.0F), 0.48F);  // 1.98 - 1.5
  EXPECT_FLOAT_EQ(kRecursion(0.0F, 5.0F), 1.5F);
  EXPECT_FLOAT_EQ(kRecursion(0.0F, -1.5F), -1.5F);
}

TEST(Recursion, StaysInsideItsBounds) {
  EXPECT_FLOAT_EQ(kRecursion(4.0F, 1.0F), 4.0F);
  EXPECT_FLOAT_EQ(kRecursion(-2.9F, -1.0F), -3.0F);
}

TEST(Recursion, TwoSupportsByHand) {
  // p(0) = 0.5: dL = 0.8 * 0.5 = 0.4. p(0.4) = 0.5986877: dL = 0.8 * 0.4013123 = 0.3210498; 0.99 * 0.4 +
  // 0.3210498 = 0.7170498.
  float log_odds = 0;
  for (int scan = 0; scan < 2; ++scan)
    log_odds = kRecursion(log_odds, support_increment(0.8F, p_from_log_odds(log_odds)));
  EXPECT_NEAR(log_odds, 0.7170498F, kStep);
}

TEST(Recursion, SupportForEverReachesAFixedPointBelowTheBound) {
  // lambda L = eta (1 - p(L)) with lambda = 0.01, eta = 0.8: both sides are 0.0324 at L = 3.2412.
  float log_odds = 0;
  for (int scan = 0; scan < 2000; ++scan) {
    const float next = kRecursion(log_odds, support_increment(0.8F, p_from_log_odds(log_odds)));
    EXPECT_GE(next, log_odds - kStep);
    log_odds = next;
  }
  EXPECT_NEAR(0.01F * log_odds, 0.8F * (1 - p_from_log_odds(log_odds)), 1e-5F);
  EXPECT_LT(log_odds, 4.0F);
}

TEST(Recursion, ALongPastIsUndoneInAFewScans) {
  // The anti-accumulation rules: from the upper bound 4, conflicts of 1.2 need four scans to pass tau_dyn,
  // ln(3 / 7) = -0.847: 4, 2.76, 1.532, 0.317, -0.886.
  float log_odds = 4;
  int scans = 0;
  for (; p_from_log_odds(log_odds) > 0.3F; ++scans) log_odds = kRecursion(log_odds, -1.2F);
  EXPECT_EQ(scans, 4);
  EXPECT_NEAR(log_odds, -0.886F, 1e-3F);
}

}  // namespace
}  // namespace stillmap
