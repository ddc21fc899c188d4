// Where rows lie in the map: against voxel_key() row by row.
#include "core/located_rows.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/made_scans.hpp"

namespace stillmap {
namespace {

TEST(LocatedRows, AreWhereVoxelKeySays) {
  constexpr double kVoxel_m = 0.1;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> near_m(-60, 60);
  Scan scan;
  for (int i = 0; i < 5000; ++i)
    scan.points.emplace_back(i % 7 == 0 ? Eigen::Vector3f::Zero()
                                        : Eigen::Vector3f(near_m(random), near_m(random), near_m(random)));
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(0.5, 0.1, 0.3, -0.7).normalized().toRotationMatrix();
  T.translation() = Eigen::Vector3d(-2103.2, 155.1, 3.3);
  const ProjectedScan p = projected(scan);
  LocatedRows rows;
  rows.locate(p, T, 1 / kVoxel_m);
  std::size_t located = 0;
  for (std::size_t row = 0; row < p.size(); ++row) {
    if (!(p.range_m[row] > 0)) {
      EXPECT_EQ(rows.block[row], LocatedRows::kNowhere);
      continue;
    }
    ++located;
    const Eigen::Vector3d edges = T * scan.points[row].cast<double>() / kVoxel_m;
    const VoxelKey key = voxel_key(unpacked(rows.block[row]), rows.place[row]);
    const Eigen::Vector3d back = key.cast<double>() + rows.offset(row).cast<double>();
    EXPECT_LT((back - edges).norm(), 1e-6);
    EXPECT_GE(rows.offset(row).minCoeff(), 0);
    EXPECT_LE(rows.offset(row).maxCoeff(), 1);
  }
  EXPECT_GT(located, 3000U);
}

TEST(LocatedRows, BeyondTheMapsLimitsIsNowhere) {
  Scan scan;
  scan.points = {{10, 0, 0}, {-10, 0, 0}};
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation().x() = kVoxelKeyLimit * 0.1;
  LocatedRows rows;
  rows.locate(projected(scan), T, 10.0);
  EXPECT_EQ(rows.block[0], LocatedRows::kNowhere);
  EXPECT_NE(rows.block[1], LocatedRows::kNowhere);
  T.translation().x() = 1e18;
  rows.locate(projected(scan), T, 10.0);
  EXPECT_EQ(rows.block[1], LocatedRows::kNowhere);
}

}  // namespace
}  // namespace stillmap
