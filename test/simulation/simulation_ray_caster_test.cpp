// What a ray meets first: the tree of boxes against trying everything, movers at their time, leaves.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/bodies.hpp"
#include "simulation/path.hpp"
#include "simulation/plants.hpp"
#include "simulation/ray_caster.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector3d;

Vector3d some_direction(Random* random) {
  Vector3d direction(random->normal(), random->normal(), random->normal());
  return direction.normalized();
}

Shape some_shape(Random* random) {
  const Vector3d at = 15 * Vector3d(random->normal(), random->normal(), random->normal());
  switch (random->integer(0, 4)) {
    case 0:
      return make_box(pose_at(at.x(), at.y(), at.z(), random->uniform(0, 6)), {1, 2, 3}, surfaces::kFacade);
    case 1:
      return make_cylinder_between(at, at + some_direction(random), 0.3, surfaces::kPole);
    case 2:
      return make_capsule(at, at + 2 * some_direction(random), 0.4, surfaces::kClothes);
    case 3:
      return make_ellipsoid(at, {1, 0.5, 2}, surfaces::kSkin);
    default:
      return make_disc(at, some_direction(random), 0.8, surfaces::kLeaf);
  }
}

TEST(RayCaster, FindsWhatTryingEverythingFinds) {
  Random random(11);
  World world;
  for (int i = 0; i < 600; ++i) {
    Sway sway;
    if (i % 3 == 0) sway = {0.3F, 0.7F, static_cast<float>(i)};
    world.add(some_shape(&random), sway);
  }
  const RayCaster caster(world);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const double time_s = random.uniform(0, 10), max_range_m = 60;
    const Ray ray{5 * some_direction(&random), some_direction(&random)};
    RayCaster::MoversInSweep movers(world, time_s, time_s);
    double nearest_m = max_range_m;
    for (const Fixture& fixture : world.fixtures()) {
      const auto crossing =
          fixture.shape.cross({ray.origin - fixture.sway.displacement_m(time_s), ray.direction});
      if (crossing) nearest_m = std::min(nearest_m, crossing->range_m);
    }
    const auto hit = caster.cast(ray, time_s, max_range_m, &movers);
    ASSERT_EQ(hit.has_value(), nearest_m < max_range_m) << "ray " << i;
    if (!hit) continue;
    EXPECT_NEAR(hit->range_m, nearest_m, 1e-12);
    ++hits;
  }
  EXPECT_GT(hits, 500);
}

TEST(RayCaster, MoverIsWhereItIsAtThatTime) {
  World world;
  Mover car;
  car.body = {{make_box(pose_at(0, 0, 0.5), {2, 2, 1}, surfaces::kMetal)}};
  car.motion = [](double time_s) { return MoverPose{pose_at(10 + 5 * time_s, 0, 0), 5 * time_s}; };
  const std::uint16_t instance = world.add_mover(car);
  const RayCaster caster(world);
  const Ray ahead{{0, 0, 0.5}, Vector3d::UnitX()};
  RayCaster::MoversInSweep movers(world, 0, 2);
  EXPECT_NEAR(caster.cast(ahead, 0, 100, &movers)->range_m, 9, 1e-12);
  const auto later = caster.cast(ahead, 2, 100, &movers);
  ASSERT_TRUE(later);
  EXPECT_NEAR(later->range_m, 19, 1e-12);
  EXPECT_EQ(later->instance, instance);
  EXPECT_EQ(later->mover, &world.movers()[0]);
}

TEST(RayCaster, LegsSwingOnlyWhileWalking) {
  Random random(1);
  World world;
  world.add_ground(0, surfaces::kRoad);
  Mover person;
  person.body = person_body(&random);
  person.motion = along(Path({{5, 0}, {50, 0}}), SpeedProfile::starting(1, 1), world.ground);
  world.add_mover(person);
  const auto shape_of_legs = [&](double time_s) {
    const RayCaster caster(world);
    RayCaster::MoversInSweep movers(world, time_s, time_s);
    const double x = person.motion(time_s).T_map_body.translation().x();
    std::vector<double> ranges;
    for (double z = 0.1; z < 0.8; z += 0.05) {
      for (double y = -0.2; y < 0.2; y += 0.02) {
        const auto hit = caster.cast({{x - 3, y, z}, Vector3d::UnitX()}, time_s, 4, &movers);
        ranges.push_back(hit ? hit->range_m : 0);
      }
    }
    return ranges;
  };
  EXPECT_EQ(shape_of_legs(0), shape_of_legs(0.9));
  EXPECT_NE(shape_of_legs(2.0), shape_of_legs(2.3));
}

TEST(RayCaster, FoliageIsPorousAndSways) {
  Random random(4);
  World world;
  add_foliage(&world, {{10, 0, 0}, {1, 1, 1}, 150, 0.07, 0.08}, &random);
  const RayCaster caster(world);
  int met = 0, met_later = 0, changed = 0, rays = 0;
  for (double y = -0.7; y < 0.7; y += 0.03) {
    for (double z = -0.7; z < 0.7; z += 0.03) {
      const Ray ray{{0, y, z}, Vector3d::UnitX()};
      RayCaster::MoversInSweep movers(world, 0, 0);
      const bool now = caster.cast(ray, 0, 50, &movers).has_value();
      const bool later = caster.cast(ray, 0.8, 50, &movers).has_value();
      met += now ? 1 : 0;
      met_later += later ? 1 : 0;
      changed += now != later ? 1 : 0;
      ++rays;
    }
  }
  EXPECT_GT(met, rays / 5);
  EXPECT_LT(met, rays * 4 / 5) << "rays pass between the leaves";
  EXPECT_NEAR(met, met_later, rays / 10);
  EXPECT_GT(changed, rays / 10) << "other rays than before";
}

}  // namespace
}  // namespace stillmap::simulation
