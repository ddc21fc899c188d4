// The simulator as a whole: every scene with every sensor, the same bytes again, other worlds for other
// seeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "simulation/simulator.hpp"

namespace stillmap {
namespace {

SimulationOptions short_scene(const std::string& scene, const std::string& sensor = "vlp16") {
  SimulationOptions options;
  options.scene = scene;
  options.sensor = sensor;
  options.scans = 6;
  return options;
}

bool same(const SimulatedFrame& a, const SimulatedFrame& b) {
  const auto& p = a.frame.scan.points;
  const auto& q = b.frame.scan.points;
  return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof(p[0])) == 0 &&
         a.frame.T_map_sensor.matrix() == b.frame.T_map_sensor.matrix() && a.intensity == b.intensity &&
         a.ring == b.ring && a.labels == b.labels && a.labels_now == b.labels_now &&
         a.frame.name == b.frame.name && a.frame.scan.stamp_ns == b.frame.scan.stamp_ns;
}

std::size_t moving_points(const std::vector<std::uint32_t>& labels) {
  return static_cast<std::size_t>(std::count_if(labels.begin(), labels.end(),
                                                [](std::uint32_t label) { return (label & 0xffffU) > 250; }));
}

TEST(Simulator, EverySceneWorksWithEverySensor) {
  for (const std::string& scene : Simulator::scene_names()) {
    for (const std::string& sensor : Simulator::sensor_names()) {
      const SimulatedFrame scan = Simulator(short_scene(scene, sensor)).frame(0);
      const std::size_t count = scan.frame.scan.points.size();
      EXPECT_GT(count, 1500U) << scene << " with " << sensor;
      EXPECT_EQ(scan.intensity.size(), count);
      EXPECT_EQ(scan.ring.size(), count);
      EXPECT_EQ(scan.labels.size(), count);
      EXPECT_EQ(scan.labels_now.size(), count);
      for (const Eigen::Vector3f& point : scan.frame.scan.points) ASSERT_TRUE(point.allFinite());
    }
  }
}

TEST(Simulator, SomethingMovesInEveryScene) {
  for (const std::string& scene : Simulator::scene_names()) {
    const SimulatedFrame scan = Simulator(short_scene(scene)).frame(3);
    EXPECT_GT(moving_points(scan.labels), 50U) << scene;
    EXPECT_LT(moving_points(scan.labels), scan.labels.size() / 3) << scene;
  }
}

TEST(Simulator, GivesTheSameBytesInAnyOrder) {
  const Simulator first(short_scene("orchard")), second(short_scene("orchard"));
  const SimulatedFrame a3 = first.frame(3), a1 = first.frame(1);
  EXPECT_TRUE(same(a1, second.frame(1)));
  EXPECT_TRUE(same(a3, second.frame(3)));
  EXPECT_TRUE(same(a3, first.frame(3)));
}

TEST(Simulator, FewerColumnsThinTheScan) {
  SimulationOptions options = short_scene("street");
  const std::size_t all = Simulator(options).frame(0).frame.scan.points.size();
  options.columns = 180;
  const double tenth = static_cast<double>(Simulator(options).frame(0).frame.scan.points.size());
  EXPECT_NEAR(tenth, static_cast<double>(all) / 10, static_cast<double>(all) / 100);
}

TEST(Simulator, SeedsMakeOtherWorlds) {
  SimulationOptions options = short_scene("street");
  const SimulatedFrame one = Simulator(options).frame(0);
  options.seed = 2;
  const SimulatedFrame two = Simulator(options).frame(0);
  const auto instances = [](const SimulatedFrame& scan) {
    return std::set<std::uint32_t>(scan.labels.begin(), scan.labels.end()).size();
  };
  EXPECT_NE(one.frame.scan.points.size(), two.frame.scan.points.size());
  EXPECT_NE(instances(one), instances(two));
}

TEST(Simulator, PosesAreNoisyByTheNoiseAskedFor) {
  SimulationOptions options = short_scene("plaza");
  const SimulatedFrame noisy = Simulator(options).frame(2);
  const double error_m =
      (noisy.frame.T_map_sensor.translation() - noisy.T_map_sensor_true.translation()).norm();
  EXPECT_GT(error_m, 0);
  EXPECT_LT(error_m, 0.06);
  options.pose_noise_m = options.pose_noise_deg = options.drift_percent = 0;
  const SimulatedFrame exact = Simulator(options).frame(2);
  EXPECT_TRUE(exact.frame.T_map_sensor.isApprox(exact.T_map_sensor_true, 1e-12));
}

TEST(Simulator, StampsAndNamesCount) {
  SimulationOptions options = short_scene("plaza");
  options.rate_hz = 20;
  const Simulator simulator(options);
  EXPECT_EQ(simulator.size(), 6U);
  EXPECT_EQ(simulator.frame(3).frame.scan.stamp_ns, 150'000'000);
  EXPECT_EQ(simulator.frame(3).frame.name, "000003");
}

TEST(Simulator, EgoSpeedIsObeyed) {
  SimulationOptions options = short_scene("street");
  options.ego_speed_mps = 4;
  const Simulator simulator(options);
  const double way_m = (simulator.frame(5).T_map_sensor_true.translation() -
                        simulator.frame(0).T_map_sensor_true.translation())
                           .norm();
  EXPECT_NEAR(way_m, 2.0, 0.02);
}

TEST(Simulator, BadOptionsAreRefusedByName) {
  const auto refusal = [](const auto& change) -> std::string {
    SimulationOptions options = short_scene("plaza");
    change(options);
    try {
      Simulator simulator(options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  using Options = SimulationOptions;
  const auto names = [](const std::string& message, const char* what) {
    return message.find(what) != std::string::npos;
  };
  EXPECT_TRUE(names(refusal([](Options& o) { o.scene = "moon"; }), "moon"));
  EXPECT_TRUE(names(refusal([](Options& o) { o.sensor = "eye"; }), "eye"));
  EXPECT_TRUE(names(refusal([](Options& o) { o.rate_hz = 0; }), "rate_hz"));
  EXPECT_TRUE(names(refusal([](Options& o) { o.rate_hz = std::nan(""); }), "rate_hz"));
  EXPECT_TRUE(names(refusal([](Options& o) { o.ego_speed_mps = -1; }), "ego_speed_mps"));
  EXPECT_TRUE(names(refusal([](Options& o) { o.drop_percent = 101; }), "drop_percent"));
  EXPECT_TRUE(names(refusal([](Options& o) { o.columns = 5000; }), "columns"));
  EXPECT_TRUE(names(refusal([](Options& o) { o.sensor = "livox", o.columns = 100; }), "columns"));
  EXPECT_THROW(Simulator(short_scene("plaza")).frame(6), std::invalid_argument);
}

}  // namespace
}  // namespace stillmap
