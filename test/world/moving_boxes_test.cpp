// A car and a person cross before the sensor: the boxes must lie where the simulator has them.
#include <gtest/gtest.h>

#include "simulation/path.hpp"
#include "simulation/structures.hpp"
#include "simulation/traffic.hpp"
#include "world/world_run.hpp"

namespace stillmap::simulation {
namespace {

TEST(MovingBoxes, LieAroundWhatMoves) {
  World world;
  world.add_ground(0, surfaces::kRoad);
  add_wall(&world, {25, -40}, {25, 40}, 0.3, 5, surfaces::kWall);
  Mover cart;
  cart.body = {{make_box(pose_at(0, 0, 1), {3, 1.4, 1.6}, surfaces::kMetal)}};
  cart.motion = along(Path({{8, -14}, {16, 14}}), SpeedProfile::constant(6), world.ground);
  cart.class_moving = kMovingOther;
  world.add_mover(std::move(cart));
  Random random(2);
  add_person(&world, Path({{9, 12}, {9, -12}}), SpeedProfile::constant(1.5), &random);

  Mapper mapper{on_two_threads()};
  const RayCaster caster(world);
  const SensorModel sensor = sensor_model("os1_64");
  int scans = 0, found = 0;
  for (int k = 0; k < 30; ++k) {
    Sweep sweep;
    sweep.middle_s = 0.1 * k;
    sweep.index = static_cast<std::uint64_t>(k);
    const SimulatedFrame truth = cast_scan(caster, sensor, standing_at(0, 0, 1.7), sweep, {});
    mapper.process(truth.frame.scan, truth.frame.T_map_sensor);
    if (k < 10) continue;
    const std::vector<MovingBox> boxes = mapper.moving_boxes(truth.frame.scan, truth.frame.T_map_sensor);
    for (const Mover& mover : world.movers()) {
      const Eigen::Vector3d place = mover.motion(sweep.middle_s).T_map_body.translation();
      ++scans;
      for (const MovingBox& box : boxes) {
        // The sensor sees the near side only: the thing's middle lies in the box or right behind it.
        const Eigen::Vector3d off = box.T_map_box.inverse() * (place + Eigen::Vector3d(0, 0, 0.9));
        const bool around = (off.array().abs() <= box.size_m.array() / 2 + 0.8).all();
        const bool as_large = box.size_m.x() < 3.6 && box.size_m.y() < 3.6 && box.size_m.z() < 2.2;
        if (!around || !as_large) continue;
        ++found;
        break;
      }
    }
  }
  EXPECT_GE(measured("movers with a box, %", 100.0 * found / scans), 90);
}

TEST(MovingBoxes, AreNoneWhereNothingMovesOrTheScanIsAnother) {
  World world;
  world.add_ground(0, surfaces::kRoad);
  add_wall(&world, {12, -20}, {12, 20}, 0.3, 5, surfaces::kWall);
  Mapper mapper{on_two_threads()};
  const auto scans = run(&mapper, world, standing_at(0, 0, 1.5), {"vlp16", 10});
  const Frame& last = scans.back().truth.frame;
  EXPECT_TRUE(mapper.moving_boxes(last.scan, last.T_map_sensor).empty());
  EXPECT_TRUE(mapper.moving_boxes(Scan(), last.T_map_sensor).empty());
}

}  // namespace
}  // namespace stillmap::simulation
