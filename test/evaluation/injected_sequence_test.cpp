#include "evaluation/injected_sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "baselines/small_world.hpp"
#include "evaluation/semantic_classes.hpp"
#include "support/expect_error.hpp"

namespace stillmap {
namespace {

/// A field with a wall all around, seen six times at 10 Hz from the same place.
struct Field : Sequence {
  Frame frame;
  Field() {
    SmallWorld world;
    for (const double side : {-14.0, 14.0}) {
      world.add_box({std::min(side, side + 1) - 0.5, -15, 0}, {side + 1, 15, 5});
      world.add_box({-15, std::min(side, side + 1) - 0.5, 0}, {15, side + 1, 5});
    }
    frame = world.scan({0, 0, 1.7}, 1.0);
  }
  std::size_t size() const override { return 6; }
  Frame read(std::size_t index) override {
    frame.scan.stamp_ns = static_cast<std::int64_t>(index) * 100'000'000;
    return frame;
  }
};

InjectedSequence inject(const InjectionOptions& options) {
  return InjectedSequence(std::make_unique<StandingSequence>(std::make_unique<Field>()), options);
}

InjectionOptions all_points() {
  InjectionOptions options;
  options.max_points = 0;
  return options;
}

std::map<std::uint32_t, std::size_t> count_moving(const LabelledFrame& scan) {
  std::map<std::uint32_t, std::size_t> counts;
  for (const std::uint32_t label : scan.labels)
    if (is_moving(label)) ++counts[label];
  return counts;
}

TEST(InjectedSequence, OverlayAddsThePapersCountsAndHidesNothing) {
  InjectionOptions options = all_points();
  options.overlay = true;
  InjectedSequence sequence = inject(options);
  const LabelledFrame scan = sequence.read(2);
  const auto counts = count_moving(scan);
  ASSERT_EQ(counts.size(), 3u);
  std::size_t people = 0, vehicles = 0;
  for (const auto& [label, points] : counts) {
    if (class_of(label) == 254) {
      ++people;
      EXPECT_EQ(points, 260u);
    } else {
      ++vehicles;
      EXPECT_EQ(class_of(label), 259u);
      EXPECT_EQ(points, 420u);
    }
  }
  EXPECT_EQ(people, 2u);
  EXPECT_EQ(vehicles, 1u);
  const Frame recorded = Field().read(2);
  ASSERT_EQ(scan.labels.size(), recorded.scan.points.size() + 940);
  EXPECT_TRUE(
      std::equal(recorded.scan.points.begin(), recorded.scan.points.end(), scan.frame.scan.points.begin()));
}

TEST(InjectedSequence, TargetsHideWhatIsBehindThem) {
  InjectedSequence sequence = inject(all_points());
  const LabelledFrame scan = sequence.read(0);
  const Frame recorded = Field().read(0);
  std::size_t hidden = 0;
  for (std::size_t row = 0; row < recorded.scan.points.size(); ++row)
    hidden += scan.frame.scan.points[row].isZero() && !recorded.scan.points[row].isZero();
  EXPECT_GT(hidden, 20u);
  EXPECT_GT(count_moving(scan).size(), 1u);
  for (std::size_t row = 0; row < scan.labels.size(); ++row) {  // no recorded return shines through a target
    if (!is_moving(scan.labels[row])) continue;
    EXPECT_LT(scan.frame.scan.points[row].norm(), 15.0F);
  }
}

TEST(InjectedSequence, TargetsShowTheSideThatFacesTheSensor) {
  InjectionOptions options = all_points();
  options.people = 0;
  InjectedSequence sequence = inject(options);
  const LabelledFrame scan = sequence.read(0);
  float nearest_m = 1e9F, farthest_m = 0;
  std::size_t points = 0;
  for (std::size_t row = 0; row < scan.labels.size(); ++row) {
    if (!is_moving(scan.labels[row])) continue;
    nearest_m = std::min(nearest_m, scan.frame.scan.points[row].norm());
    farthest_m = std::max(farthest_m, scan.frame.scan.points[row].norm());
    ++points;
  }
  EXPECT_GT(points, 350u);
  EXPECT_LT(farthest_m - nearest_m, 2.2F);
}

TEST(InjectedSequence, TargetsMoveAtTheirSpeed) {
  InjectionOptions options = all_points();
  options.overlay = true;
  InjectedSequence sequence = inject(options);
  const auto centre = [&](std::size_t k) {
    const LabelledFrame scan = sequence.read(k);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float count = 0;
    for (std::size_t row = 0; row < scan.labels.size(); ++row)
      if (class_of(scan.labels[row]) == 259) sum += (scan.frame.scan.points[row] - sum) / ++count;
    return sum;
  };
  EXPECT_NEAR((centre(5) - centre(0)).norm(), 0.8 * 0.5, 0.15);
}

TEST(InjectedSequence, TheSameSeedGivesTheSameScans) {
  InjectedSequence one = inject({}), two = inject({});
  EXPECT_EQ(one.read(3).frame.scan.points, two.read(3).frame.scan.points);
  InjectionOptions other;
  other.seed = 8;
  EXPECT_NE(inject(other).read(3).frame.scan.points, one.read(3).frame.scan.points);
}

TEST(InjectedSequence, RecordedPointsAreChosenBeforeTargetsCome) {
  InjectionOptions options;
  options.max_points = 500;
  InjectedSequence sequence = inject(options);
  const LabelledFrame scan = sequence.read(0);
  EXPECT_EQ(std::count(scan.labels.begin(), scan.labels.end(), 99u), 500);
  EXPECT_FALSE(count_moving(scan).empty());
}

TEST(InjectedSequence, RefusesBadOptions) {
  InjectionOptions options;
  options.speed_mps = 0;
  expect_error<std::invalid_argument>([&] { inject(options); }, {"speed"});
  options = {};
  options.vehicle_size_m = {1, 2};
  expect_error<std::invalid_argument>([&] { inject(options); }, {"three lengths"});
}

}  // namespace
}  // namespace stillmap
