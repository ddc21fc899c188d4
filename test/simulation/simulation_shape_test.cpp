// Ray against shape, against values worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/shape.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector3d;
const Surface kAny = surfaces::kFacade;
const Ray kAlongX{{0, 0, 0}, Vector3d::UnitX()};

TEST(Shape, BoxIsEnteredAtItsNearFace) {
  const auto hit = make_box(pose_at(10, 0, 0), {2, 2, 2}, kAny).cross(kAlongX);
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->range_m, 9);
  EXPECT_DOUBLE_EQ(hit->incidence_cos, 1);
}

TEST(Shape, TurnedBoxShowsItsEdge) {
  const auto hit = make_box(pose_at(10, 0, 0, M_PI / 4), {2, 2, 2}, kAny).cross(kAlongX);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 10 - std::sqrt(2), 1e-9);
  EXPECT_NEAR(hit->incidence_cos, std::sqrt(0.5), 1e-9);
}

TEST(Shape, RayBesideBehindOrInsideMisses) {
  const Shape box = make_box(pose_at(10, 0, 0), {2, 2, 2}, kAny);
  EXPECT_FALSE(box.cross({{0, 1.5, 0}, Vector3d::UnitX()}));
  EXPECT_FALSE(box.cross({{0, 0, 0}, -Vector3d::UnitX()}));
  EXPECT_FALSE(box.cross({{10, 0, 0}, Vector3d::UnitX()})) << "a ray that starts inside leaves unhindered";
}

TEST(Shape, CylinderHasSideAndLid) {
  const Shape cylinder = make_cylinder(pose_at(5, 0, 0), 0.5, 2, kAny);
  const auto side = cylinder.cross(kAlongX);
  ASSERT_TRUE(side);
  EXPECT_DOUBLE_EQ(side->range_m, 4.5);
  const auto lid = cylinder.cross({{5.2, 0, 7}, -Vector3d::UnitZ()});
  ASSERT_TRUE(lid);
  EXPECT_DOUBLE_EQ(lid->range_m, 6);
  EXPECT_FALSE(cylinder.cross({{0, 0, 1.1}, Vector3d::UnitX()}));
}

TEST(Shape, CylinderSideIsHitAtAnAngle) {
  // At 0.3 off the axis of a cylinder of radius 0.5 the side is 0.4 before it.
  const auto hit = make_cylinder(pose_at(5, 0, 0), 0.5, 2, kAny).cross({{0, 0.3, 0}, Vector3d::UnitX()});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 4.6, 1e-12);
  EXPECT_NEAR(hit->incidence_cos, 0.8, 1e-12);
}

TEST(Shape, CapsuleHasRoundEnds) {
  const Shape capsule = make_capsule({5, 0, 0}, {5, 0, 1}, 0.5, kAny);
  const auto end = capsule.cross({{0, 0, 1.3}, Vector3d::UnitX()});
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->range_m, 4.6, 1e-9);
  const auto top = capsule.cross({{5, 0, 4}, -Vector3d::UnitZ()});
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->range_m, 2.5, 1e-9);
  EXPECT_FALSE(capsule.cross({{0, 0, 1.6}, Vector3d::UnitX()}));
}

TEST(Shape, EllipsoidKeepsItsSemiAxes) {
  const Shape ellipsoid = make_ellipsoid({10, 0, 0}, {3, 1, 2}, kAny);
  EXPECT_NEAR(ellipsoid.cross(kAlongX)->range_m, 7, 1e-12);
  EXPECT_NEAR(ellipsoid.cross({{10, -5, 0}, Vector3d::UnitY()})->range_m, 4, 1e-12);
  EXPECT_NEAR(ellipsoid.cross({{10, 0, 5}, -Vector3d::UnitZ()})->range_m, 3, 1e-12);
}

TEST(Shape, DiscIsHitWithinItsRadiusOnly) {
  const Shape disc = make_disc({4, 0, 0}, Vector3d::UnitX(), 0.1, kAny);
  EXPECT_NEAR(disc.cross({{0, 0.09, 0}, Vector3d::UnitX()})->range_m, 4, 1e-12);
  EXPECT_FALSE(disc.cross({{0, 0.11, 0}, Vector3d::UnitX()}));
}

TEST(Shape, BoundsHoldEveryShape) {
  const Shape turned = make_box(pose_at(1, 2, 3, M_PI / 4), {2, 2, 4}, kAny);
  EXPECT_TRUE(turned.bounds().min().isApprox(Vector3d(1 - std::sqrt(2), 2 - std::sqrt(2), 1)));
  const Shape lying = make_capsule({0, 0, 0}, {2, 0, 0}, 0.5, kAny);
  EXPECT_TRUE(lying.bounds().min().isApprox(Vector3d(-0.5, -0.5, -0.5)));
  EXPECT_TRUE(lying.bounds().max().isApprox(Vector3d(2.5, 0.5, 0.5)));
}

}  // namespace
}  // namespace stillmap::simulation
