// Every stage on eight threads: what one thread says, and under ThreadSanitizer no race.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "core/made_scans.hpp"
#include "core/tiles_in_a_table.hpp"
#include "stillmap/mapper.hpp"

namespace stillmap {
namespace {

/// A post that goes round in a room.
Scan room_with_a_post(int scan) {
  const RangeOf room = ground_and_wall(1.5F, 12);
  const float place_rad = 0.08F * static_cast<float>(scan);
  Scan made = Rings{16, 900, -15, 15}.scan([=](float azimuth_rad, float elevation_rad) {
    const bool is_post = std::abs(azimuth_rad - place_rad) < 0.05F;
    return is_post ? std::min(6.0F, room(azimuth_rad, elevation_rad)) : room(azimuth_rad, elevation_rad);
  });
  made.stamp_ns = scan * 100'000'000LL;
  return made;
}

Eigen::Isometry3d pose(int scan) {
  return Eigen::Isometry3d(Eigen::Translation3d(2.0 * scan, 0, 1.5));
}

struct Output {
  std::vector<ScanLabels> labels;
  MapSnapshotPtr map;
};

/// Also where the machine has fewer threads.
Output processed(int threads, Parameters p) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
  p.threads = threads;
  p.max_range_m = 20;
  TilesInATable far_tiles;
  Mapper mapper(p);
  mapper.set_tile_store(&far_tiles);
  Output output;
  for (int scan = 0; scan < 12; ++scan) {
    output.labels.push_back(mapper.process(room_with_a_post(scan), pose(scan)));
    output.labels.push_back(mapper.relabel(room_with_a_post(scan), pose(scan), output.labels.back()));
  }
  if (p.submap_length_m > 0) {
    const Eigen::Isometry3d moved(Eigen::Translation3d(0, 3, 0));
    EXPECT_TRUE(mapper.correct_newest_pose(moved).applied);
    output.labels.push_back(mapper.process(room_with_a_post(12), moved * pose(12)));
  }
  output.map = mapper.snapshot();
  return output;
}

void expect_same(const Output& a, const Output& b) {
  ASSERT_EQ(a.labels.size(), b.labels.size());
  for (std::size_t k = 0; k < a.labels.size(); ++k) {
    EXPECT_EQ(a.labels[k].label, b.labels[k].label) << "scan " << k;
    EXPECT_EQ(a.labels[k].p_static, b.labels[k].p_static) << "scan " << k;
  }
  ASSERT_EQ(a.map->voxels.size(), b.map->voxels.size());
  for (std::size_t i = 0; i < a.map->voxels.size(); ++i)
    ASSERT_EQ(a.map->voxels[i].log_odds, b.map->voxels[i].log_odds);
}

void expect_the_same_on_eight_threads(const Parameters& p) {
  const Output eight = processed(8, p);
  expect_same(eight, processed(1, p));
  std::ptrdiff_t dynamic = 0;
  for (const ScanLabels& labels : eight.labels)
    dynamic += std::count(labels.label.begin(), labels.label.end(), Label::kDynamic);
  EXPECT_GT(dynamic, 0) << "the post goes through all stages";
}

TEST(MapperThreads, EightSayWhatOneSays) {
  Parameters p;
  p.submap_length_m = 4;
  expect_the_same_on_eight_threads(p);
}

TEST(MapperThreads, WithARollingMapAndTheNearestVoxelAlone) {
  Parameters p;
  p.rolling_radius_m = 25;
  p.evidence_goes_to = "nearest_voxel";
  expect_the_same_on_eight_threads(p);
}

}  // namespace
}  // namespace stillmap
