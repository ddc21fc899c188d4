// The tables of support against the equations, for every log-odds that a voxel can hold.
#include "core/support_table.hpp"

#include <gtest/gtest.h>

namespace stillmap {
namespace {

constexpr float kClip = 1.5F, kForgetting = 0.002F;
constexpr Recursion kRecursion{kClip, kForgetting, -4, 4};

/// Three levels, the first and the last with the same rate.
std::vector<LevelModel> three_levels() {
  Parameters parameters;
  parameters.angular_levels_deg = {2.5, 2.0, 1.5};
  parameters.support_rate_r = {0.8, 0.3, 0.8};
  return level_models(parameters);
}

std::int16_t supported(std::int16_t before, const FusedEvidence& evidence) {
  Voxel voxel;
  voxel.log_odds_fixed = before;
  voxel.set_log_odds(kRecursion(voxel.log_odds(), evidence.increment(voxel.log_odds())));
  return voxel.log_odds_fixed;
}

TEST(SupportTables, RankOrdersTheLevelsByTheirRate) {
  const std::vector<LevelModel> models = three_levels();
  EXPECT_GT(models[0].support_rank, models[1].support_rank);
  EXPECT_EQ(models[0].support_rank, models[2].support_rank);
  EXPECT_GT(models[1].support_rank, 0);
}

TEST(SupportTables, GiveWhatTheEquationsGive) {
  const std::vector<LevelModel> models = three_levels();
  const SupportTables tables(models, kRecursion, false);
  FusedEvidence all;
  for (const LevelModel& model : models) all.support(model);
  for (int fixed = -32768; fixed <= 32767; ++fixed) {
    Voxel before;
    before.log_odds_fixed = static_cast<std::int16_t>(fixed);
    for (const LevelModel& model : models) {
      FusedEvidence evidence;
      evidence.support(model);
      Voxel voxel = before;
      tables.of_rank(model.support_rank).support(voxel);
      ASSERT_EQ(voxel.log_odds_fixed, supported(before.log_odds_fixed, evidence)) << fixed;
    }
    Voxel hit = before;
    tables.of_hit(hit).support(hit);
    ASSERT_EQ(hit.log_odds_fixed, supported(before.log_odds_fixed, all)) << fixed;
  }
}

TEST(SupportTables, WhatCameBackGetsTheFullRateThoughItIsDynamic) {
  const std::vector<LevelModel> models = three_levels();
  Voxel voxel;
  voxel.set_log_odds(-1);
  Voxel back = voxel;
  back.came_back = 1;
  const SupportTables tables(models, kRecursion, true);
  tables.of_hit(voxel).support(voxel);
  tables.of_hit(back).support(back);
  EXPECT_GT(back.log_odds(), voxel.log_odds());
}

}  // namespace
}  // namespace stillmap
