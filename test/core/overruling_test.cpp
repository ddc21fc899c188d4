// What the map says in the end of a mover that nobody could look through afterwards.
#include <gtest/gtest.h>

#include "core/made_scans.hpp"
#include "core/receding_van.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {
namespace {

/// Share of the van's returns in its last scans that are dynamic in the end.
double share_that_moves_in_the_end(int hits_to_overrule) {
  constexpr int kScans = 20, kLast = 4;
  Parameters parameters;
  parameters.hits_to_overrule = hits_to_overrule;
  parameters.doubt_beside_movers = parameters.settle_objects_together = false;  // which mend most of it, too
  Mapper mapper(parameters);
  const Van van{0.06F};  // each voxel is hit by two scans
  std::vector<ScanLabels> online;
  for (int k = 0; k < kScans; ++k) online.push_back(mapper.process(van.at(k), Eigen::Isometry3d::Identity()));
  int rows = 0, moving = 0;
  for (int k = kScans - kLast; k < kScans; ++k) {
    const Scan scan = van.at(k);
    const ScanLabels end = mapper.relabel(scan, Eigen::Isometry3d::Identity(), online[k]);
    for (std::size_t row = 0; row < scan.points.size(); ++row) {
      if (online[k].label[row] != Label::kDynamic) continue;
      ++rows;
      moving += end.label[row] == Label::kDynamic;
    }
  }
  EXPECT_GT(rows, 100);
  return static_cast<double>(moving) / rows;
}

TEST(Overruling, TakesMoreThanAFewReturnsOfTheMoverItself) {
  EXPECT_GT(share_that_moves_in_the_end(5), 0.99);
  EXPECT_LT(share_that_moves_in_the_end(0), 0.9);
}

// The ground that a foot stood on is static in the end; the foot was not of it.
TEST(Overruling, FeetStayWhatTheyWere) {
  const Scan ground = Rings{32, 720, -25, 5}.scan(ground_and_wall(1.7F, 20));
  for (const bool take_feet_along : {true, false}) {
    Parameters parameters;
    parameters.take_feet_along = take_feet_along;
    Mapper mapper(parameters);
    ScanLabels online;
    for (int k = 0; k < 10; ++k) online = mapper.process(ground, Eigen::Isometry3d::Identity());
    constexpr std::size_t kFoot = 10, kOther = 20;  // on the innermost ring
    for (const std::size_t row : {kFoot, kOther}) {
      ASSERT_EQ(online.label[row], Label::kStatic);
      ASSERT_EQ(online.object[row], kNoObject);
      online.label[row] = Label::kDynamic;
    }
    online.reason[kFoot] = Reason::kObjectMoves;
    online.reason[kOther] = Reason::kSeenThrough;
    const ScanLabels end = mapper.relabel(ground, Eigen::Isometry3d::Identity(), online);
    EXPECT_EQ(end.label[kFoot], take_feet_along ? Label::kDynamic : Label::kStatic);
    EXPECT_EQ(end.label[kOther], Label::kStatic);
  }
}

}  // namespace
}  // namespace stillmap
