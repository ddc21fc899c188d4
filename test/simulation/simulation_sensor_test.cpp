// Where the beams of the sensors go.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "simulation/sensor.hpp"

namespace stillmap::simulation {
namespace {

constexpr double kDegPerRad = 180 / M_PI;

TEST(Sensor, RingsLieAsInTheDataSheets) {
  const SensorModel vlp16 = sensor_model("vlp16");
  ASSERT_EQ(vlp16.ring_elevations_deg.size(), 16U);
  EXPECT_DOUBLE_EQ(vlp16.ring_elevations_deg[0], -15);
  EXPECT_DOUBLE_EQ(vlp16.ring_elevations_deg[1], -13);
  EXPECT_DOUBLE_EQ(vlp16.ring_elevations_deg[15], 15);
  const SensorModel hdl64 = sensor_model("hdl64");
  ASSERT_EQ(hdl64.ring_elevations_deg.size(), 64U);
  EXPECT_DOUBLE_EQ(hdl64.ring_elevations_deg.front(), -24.33);
  EXPECT_DOUBLE_EQ(hdl64.ring_elevations_deg.back(), 2);
  EXPECT_NEAR(hdl64.ring_elevations_deg[1] - hdl64.ring_elevations_deg[0], 0.5, 1e-9);
  EXPECT_NEAR(hdl64.ring_elevations_deg[63] - hdl64.ring_elevations_deg[62], 1.0 / 3, 1e-3);
  EXPECT_EQ(sensor_model("hdl32").ring_elevations_deg.size(), 32U);
  const SensorModel vlp32 = sensor_model("vlp32");
  ASSERT_EQ(vlp32.ring_elevations_deg.size(), 32U);
  EXPECT_DOUBLE_EQ(vlp32.ring_elevations_deg.front(), -25);
  EXPECT_NEAR(vlp32.ring_elevations_deg[20], 0, 1e-3);
  EXPECT_DOUBLE_EQ(vlp32.ring_elevations_deg.back(), 15);
  EXPECT_EQ(sensor_model("os0_128").beam_count(), 128U * 1024U);
  EXPECT_EQ(sensor_model("os1_64").beam_count(), 64U * 1024U);
  EXPECT_EQ(sensor_model("os1_128").beam_count(), 128U * 1024U);
}

TEST(Sensor, EveryRingIsSorted) {
  for (const std::string& name : sensor_model_names()) {
    const auto rings = sensor_model(name).ring_elevations_deg;
    EXPECT_TRUE(std::is_sorted(rings.begin(), rings.end())) << name;
  }
}

TEST(Sensor, SpinsClockwiseFromBehindInFiringOrder) {
  const SensorModel sensor = sensor_model("vlp16");
  const auto beams = sensor.beams(0, 0.1);
  ASSERT_EQ(beams.size(), sensor.beam_count());
  EXPECT_NEAR(beams[0].azimuth_rad, M_PI, 1e-12);
  EXPECT_EQ(beams[0].ring, 0);
  EXPECT_EQ(beams[15].ring, 15);
  EXPECT_EQ(beams[15].time_share, beams[0].time_share);
  EXPECT_NEAR((beams[0].azimuth_rad - beams[16].azimuth_rad) * kDegPerRad, 0.2, 1e-9);
  EXPECT_NEAR(beams[beams.size() / 2].azimuth_rad, 0, 1e-9) << "the middle of the sweep looks ahead";
}

TEST(Sensor, TimeNeverRunsBack) {
  for (const std::string& name : sensor_model_names()) {
    const auto beams = sensor_model(name).beams(3, 0.1);
    EXPECT_TRUE(std::is_sorted(beams.begin(), beams.end(), [](const Beam& a, const Beam& b) {
      return a.time_share < b.time_share;
    })) << name;
    EXPECT_GE(beams.front().time_share, 0);
    EXPECT_LT(beams.back().time_share, 1);
  }
}

TEST(Sensor, NonRepetitivePatternsLookElsewhereInEachSweep) {
  for (const char* name : {"livox", "mid360"}) {
    const SensorModel sensor = sensor_model(name);
    std::set<std::pair<int, int>> seen, seen_again;  // tenths of a degree
    for (std::uint64_t sweep : {10U, 11U}) {
      for (const Beam& beam : sensor.beams(sweep, 0.1)) {
        const std::pair<int, int> cell(static_cast<int>(std::floor(beam.azimuth_rad * kDegPerRad * 10)),
                                       static_cast<int>(std::floor(beam.elevation_rad * kDegPerRad * 10)));
        if (sweep == 10) seen.insert(cell);
        if (sweep == 11 && seen.count(cell) > 0) seen_again.insert(cell);
      }
    }
    EXPECT_LT(seen_again.size(), seen.size() / 4) << name;
  }
}

TEST(Sensor, FieldsOfViewAreTheirs) {
  double highest_deg = -90, widest_deg = 0;
  for (const Beam& beam : sensor_model("livox").beams(0, 0.1)) {
    highest_deg = std::max(highest_deg, beam.elevation_rad * kDegPerRad);
    widest_deg = std::max(widest_deg, std::abs(beam.azimuth_rad) * kDegPerRad);
  }
  EXPECT_NEAR(widest_deg, 35.2, 0.5);
  EXPECT_NEAR(highest_deg, 38.6, 1.0);
  for (const Beam& beam : sensor_model("mid360").beams(0, 0.1)) {
    EXPECT_GE(beam.elevation_rad * kDegPerRad, -7.001);
    EXPECT_LE(beam.elevation_rad * kDegPerRad, 52.001);
  }
}

TEST(Sensor, UnknownNameIsRefusedWithTheKnownOnes) {
  try {
    sensor_model("vlp-16");
    FAIL() << "not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("vlp-16"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("os1_128"), std::string::npos);
  }
}

}  // namespace
}  // namespace stillmap::simulation
