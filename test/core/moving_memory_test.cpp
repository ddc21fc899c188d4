// What is known of the places that a mover was seen in.
#include <gtest/gtest.h>

#include "core/receding_van.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {
namespace {

/// Of a van that recedes so slowly that each of its voxels is hit by several scans: the share of its returns
/// that are static at once.
double static_share(float speed, bool doubt) {
  constexpr int kScans = 30, kFirst = 10;
  Parameters parameters;
  parameters.doubt_beside_movers = doubt;
  Mapper mapper(parameters);
  const Van van{speed};
  int rows = 0, is_static = 0;
  for (int k = 0; k < kScans; ++k) {
    const Scan scan = van.at(k);
    const ScanLabels labels = mapper.process(scan, Eigen::Isometry3d::Identity());
    for (std::size_t row = 0; k >= kFirst && row < scan.points.size(); ++row) {
      if (scan.points[row].norm() > 20) continue;
      ++rows;
      is_static += labels.label[row] == Label::kStatic;
    }
  }
  EXPECT_GT(rows, 1000);
  return static_cast<double>(is_static) / rows;
}

TEST(MovingMemory, WhatAMoverIsSeenInIsKnownNoMore) {
  constexpr float kSpeed = 0.05F;                                             // metres a scan
  EXPECT_LT(static_share(kSpeed, true), 0.75 * static_share(kSpeed, false));  // 0.23, 0.40
}

}  // namespace
}  // namespace stillmap
