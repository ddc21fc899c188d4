// Which earlier scans are kept to judge new voxels.
#include "core/scan_history.hpp"

#include <gtest/gtest.h>

namespace stillmap {
namespace {

ScanView view_at(std::uint32_t index, double x_m) {
  Eigen::Isometry3d T_map_sensor = Eigen::Isometry3d::Identity();
  T_map_sensor.translation().x() = x_m;
  return ScanView(index, T_map_sensor, {});
}

std::vector<std::uint32_t> kept(const ScanHistory& history) {
  std::vector<std::uint32_t> indices;
  history.for_each([&](const ScanView& view) { indices.push_back(view.scan_index); });
  return indices;
}

ScanHistory after_driving(int recent, int spread, int scans, double step_m) {
  ScanHistory history(recent, spread);
  for (int i = 0; i < scans; ++i) history.add(view_at(static_cast<std::uint32_t>(i), i * step_m));
  return history;
}

TEST(ScanHistory, KeepsEverythingUntilItIsFull) {
  EXPECT_EQ(kept(after_driving(3, 2, 5, 1)), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(ScanHistory, TheNewestAreAlwaysThere) {
  const ScanHistory history = after_driving(4, 3, 100, 1);
  EXPECT_EQ(history.size(), 7U);
  const std::vector<std::uint32_t> indices = kept(history);
  EXPECT_EQ(std::vector<std::uint32_t>(indices.end() - 4, indices.end()),
            (std::vector<std::uint32_t>{96, 97, 98, 99}));
  EXPECT_TRUE(std::is_sorted(indices.begin(), indices.end())) << "oldest first";
}

TEST(ScanHistory, RecentCountsBackFromTheNewest) {
  const ScanHistory history = after_driving(4, 3, 10, 1);
  EXPECT_EQ(history.recent(1)->scan_index, 9U);
  EXPECT_EQ(history.recent(4)->scan_index, 6U);
  EXPECT_EQ(history.recent(5), nullptr);
  EXPECT_EQ(history.recent(0), nullptr);
}

TEST(ScanHistory, OldScansThinOutWithDistance) {
  const std::vector<std::uint32_t> indices = kept(after_driving(5, 8, 300, 0.5));
  ASSERT_EQ(indices.size(), 13U);
  EXPECT_LE(indices.front(), 300U - 50U) << "8 scans reach back 25 m at least";
  EXPECT_GT(indices[1] - indices[0], 2 * (indices[8] - indices[7]));
}

TEST(ScanHistory, AStandingSensorSpreadsOverTime) {
  const std::vector<std::uint32_t> indices = kept(after_driving(5, 8, 200, 0));
  ASSERT_EQ(indices.size(), 13U);
  EXPECT_LT(indices.front(), 100U) << "the past is not only the last moments";
}

TEST(ScanHistory, OfNoScansKeepsNone) {
  EXPECT_EQ(after_driving(0, 0, 20, 1).size(), 0U);
  EXPECT_EQ(kept(after_driving(0, 3, 20, 1)).size(), 3U);
  EXPECT_EQ(kept(after_driving(2, 0, 20, 1)), (std::vector<std::uint32_t>{18, 19}));
}

TEST(ScanHistory, ClearForgetsAll) {
  ScanHistory history = after_driving(4, 3, 10, 1);
  history.clear();
  EXPECT_EQ(history.size(), 0U);
  EXPECT_EQ(history.recent(1), nullptr);
}

}  // namespace
}  // namespace stillmap
