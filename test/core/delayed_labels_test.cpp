#include "stillmap/delayed_labels.hpp"

#include <gtest/gtest.h>

#include "tools/room_sequence.hpp"

namespace stillmap {
namespace {

struct DelayedLabelsTest : testing::Test {
  Mapper mapper{Parameters()};
  DelayedLabels<Frame> waiting{3};
  std::vector<ScanLabels> online;

  std::optional<DelayedLabels<Frame>::Settled> process(std::size_t k) {
    const Frame frame = room_frame(k);
    online.push_back(mapper.process(frame.scan, frame.T_map_sensor));
    return waiting.add(mapper, frame, online.back());
  }
  ScanLabels judged_now(std::size_t k) const {
    const Frame frame = room_frame(k);
    return mapper.relabel(frame.scan, frame.T_map_sensor, online[k]);
  }
};

TEST_F(DelayedLabelsTest, GivesEachScanAsTheMapSeesItLater) {
  for (std::size_t k = 0; k < 10; ++k) {
    const auto settled = process(k);
    ASSERT_EQ(settled.has_value(), k >= 3) << k;
    if (!settled) continue;
    EXPECT_EQ(settled->scan.name, room_frame(k - 3).name);
    EXPECT_EQ(settled->scan.scan.stamp_ns, room_frame(k - 3).scan.stamp_ns);
    EXPECT_EQ(settled->labels.label, judged_now(k - 3).label);
    EXPECT_EQ(settled->labels.reason, judged_now(k - 3).reason);
  }
}

TEST_F(DelayedLabelsTest, SaysWhatTheScansOwnTimeCouldNot) {
  std::size_t changed = 0;
  for (std::size_t k = 0; k < 10; ++k)
    if (const auto settled = process(k)) changed += settled->labels.label != online[k - 3].label;
  EXPECT_GT(changed, 0u);
}

TEST_F(DelayedLabelsTest, TheLastOnesAreSettledByWhatThereIs) {
  for (std::size_t k = 0; k < 5; ++k) process(k);
  for (std::size_t k = 2; k < 5; ++k) {
    const auto settled = waiting.settle_oldest(mapper);
    ASSERT_TRUE(settled) << k;
    EXPECT_EQ(settled->scan.name, room_frame(k).name);
    EXPECT_EQ(settled->labels.label, judged_now(k).label);
  }
  EXPECT_FALSE(waiting.settle_oldest(mapper));
}

TEST_F(DelayedLabelsTest, AResetMapDoesNotJudgeWhatWasBefore) {
  for (std::size_t k = 0; k < 3; ++k) process(k);
  mapper.reset();
  EXPECT_FALSE(process(3));
  const auto settled = waiting.settle_oldest(mapper);
  ASSERT_TRUE(settled);
  EXPECT_EQ(settled->scan.name, room_frame(3).name);
  EXPECT_FALSE(waiting.settle_oldest(mapper));
}

}  // namespace
}  // namespace stillmap
