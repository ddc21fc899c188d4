#include "core/structure_gates.hpp"

#include <gtest/gtest.h>

#include "baselines/support_map.hpp"

namespace stillmap {
namespace {

constexpr double kVoxel_m = 0.1;

/// Ground all around at z = 0, hit once; a post of three voxels at (1, 1), z = 1.0 to 1.2, hit `hits` times.
SupportMap post_on_ground(int hits, const GateSettings& gates) {
  SupportMap map(kVoxel_m, gates);
  Frame ground;
  for (int x = -40; x < 40; ++x)
    for (int y = -40; y < 40; ++y)
      ground.scan.points.emplace_back(0.1F * static_cast<float>(x) + 0.05F,
                                      0.1F * static_cast<float>(y) + 0.05F, 0.05F);
  map.add(ground);
  Frame post;
  for (const float z : {1.05F, 1.15F, 1.25F, 1.15F}) post.scan.points.emplace_back(1.05F, 1.05F, z);
  for (int scan = 0; scan < hits; ++scan) map.add(post);
  return map;
}

bool may_stand(int hits, const GateSettings& gates, const Eigen::Vector3d& at = {1.05, 1.05, 1.15}) {
  const SupportMap map = post_on_ground(hits, gates);
  return map.gates().dynamic_may_stand(map.key_of(at));
}

TEST(StructureGates, AllOffLetsEverythingStand) {
  EXPECT_FALSE(GateSettings().any());
  EXPECT_TRUE(may_stand(50, {}));
}

TEST(StructureGates, VoxelSupportCountsScansNotReturns) {
  GateSettings gates;
  gates.voxel_support = 3;
  EXPECT_TRUE(may_stand(2, gates));
  EXPECT_FALSE(may_stand(3, gates));
}

TEST(StructureGates, FewPointsAroundAndInTheColumnOutweighVoxelSupport) {
  GateSettings gates;
  gates.voxel_support = 3;
  gates.neighbourhood_support = 13;  // 4 hits of 3 voxels: 12
  gates.grid_support = 14;           // and the ground below: 13
  EXPECT_TRUE(may_stand(4, gates));
  gates.grid_support = 13;
  EXPECT_FALSE(may_stand(4, gates));
  gates.grid_support = 14;
  gates.neighbourhood_support = 12;
  EXPECT_FALSE(may_stand(4, gates));
}

TEST(StructureGates, ColumnAlone) {
  GateSettings gates;
  gates.grid_support = 12;
  EXPECT_TRUE(may_stand(3, gates));
  EXPECT_FALSE(may_stand(4, gates));
}

TEST(StructureGates, WhatIsNearTheGroundStays) {
  GateSettings gates;
  gates.height_above_ground_m = 0.6;
  EXPECT_TRUE(may_stand(1, gates));
  EXPECT_FALSE(may_stand(1, gates, {1.05, 1.05, 0.55}));
  gates.height_above_ground_m = 1.2;
  EXPECT_FALSE(may_stand(1, gates));
}

TEST(StructureGates, TheParametersName) {
  const GateSettings gates = gate_settings(preset("paper"));
  EXPECT_EQ(gates.voxel_support, 3);
  EXPECT_EQ(gates.neighbourhood_support, 60);
  EXPECT_EQ(gates.grid_support, 12);
  EXPECT_DOUBLE_EQ(gates.height_above_ground_m, 0.6);
  EXPECT_FALSE(gate_settings(Parameters()).any());
}

}  // namespace
}  // namespace stillmap
