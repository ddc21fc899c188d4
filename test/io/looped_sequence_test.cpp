#include "io/looped_sequence.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace stillmap {
namespace {

/// Steps of 2 m along x, and one to the left in the middle, 100 ms apart.
class ThreeScans : public Sequence {
 public:
  explicit ThreeScans(std::size_t size = 3) : size_(size) {}
  std::size_t size() const override { return size_; }
  Frame read(std::size_t index) override {
    Frame frame;
    frame.scan.stamp_ns = 1000 + static_cast<std::int64_t>(index) * 100;
    frame.T_map_sensor.translation() =
        Eigen::Vector3d(5 + 2.0 * static_cast<double>(index), index == 1 ? 1 : 0, 0);
    frame.T_map_sensor.linear() =
        Eigen::AngleAxisd(0.1 * static_cast<double>(index), Eigen::Vector3d::UnitZ()).matrix();
    return frame;
  }

 private:
  std::size_t size_;
};

TEST(LoopedSequence, GoesOnOneStepAfterTheEnd) {
  ThreeScans lap;
  LoopedSequence loop(lap, 8);
  EXPECT_EQ(loop.size(), 8u);
  for (std::size_t k = 0; k < 8; ++k) {
    const Frame frame = loop.read(k), of_lap = lap.read(k % 3);
    EXPECT_DOUBLE_EQ(frame.T_map_sensor.translation().x(), 5 + 2.0 * static_cast<double>(k));
    EXPECT_EQ(frame.scan.stamp_ns, 1000 + static_cast<std::int64_t>(k) * 100);
    EXPECT_EQ(frame.T_map_sensor.linear(), of_lap.T_map_sensor.linear());
    EXPECT_EQ(frame.name, std::to_string(k));
  }
  // the last step went 1 m to the right, and so does each lap
  EXPECT_DOUBLE_EQ(loop.read(3).T_map_sensor.translation().y(), -1);
  EXPECT_DOUBLE_EQ(loop.read(6).T_map_sensor.translation().y(), -2);
}

TEST(LoopedSequence, NeedsAStep) {
  ThreeScans one(1);
  expect_error([&] { LoopedSequence(one, 5); }, {"1 scans", "two or more"});
}

}  // namespace
}  // namespace stillmap
