#include "simulation/bodies.hpp"

#include <cmath>

namespace stillmap::simulation {
namespace {

using Eigen::Vector3d;

Part box_part(double x, double y, double z, const Vector3d& size_m, const Surface& surface) {
  return {make_box(pose_at(x, y, z), size_m, surface)};
}

Surface paint(Random* random, std::uint16_t semantic_class) {
  const bool is_black = random->chance(0.2);
  const double reflectivity = is_black ? 0.06 : random->uniform(0.2, 0.7);
  return {semantic_class, static_cast<float>(reflectivity), is_black ? 0.8F : 0.97F};
}

Surface of_class(Surface surface, std::uint16_t semantic_class) {
  surface.semantic_class = semantic_class;
  return surface;
}

void add_wheels(Body* body, double wheelbase_m, double track_m, double radius_m,
                std::uint16_t semantic_class) {
  const Surface tyre = of_class(surfaces::kTyre, semantic_class);
  for (const double x : {-wheelbase_m / 2, wheelbase_m / 2}) {
    for (const double y : {-track_m / 2, track_m / 2}) {
      body->push_back(
          {make_cylinder_between({x, y - 0.1, radius_m}, {x, y + 0.1, radius_m}, radius_m, tyre)});
    }
  }
}

/// A limb that hangs from `top` and swings about it.
Part limb(const Vector3d& top, double length_m, double radius_m, double amplitude_rad, double phase_rad,
          double stride_m, const Surface& surface) {
  const Vector3d bottom = top - Vector3d(0, 0, length_m);
  return {make_capsule(top, bottom, radius_m, surface), {top, amplitude_rad, phase_rad, stride_m}};
}

}  // namespace

Body car_body(Random* random) {
  const double length_m = random->uniform(3.8, 4.9), width_m = random->uniform(1.68, 1.88);
  const double waist_m = random->uniform(0.85, 1.0), height_m = waist_m + random->uniform(0.5, 0.75);
  const double cabin_m = length_m * random->uniform(0.48, 0.62), cabin_x = -random->uniform(0.1, 0.5);
  const Surface body_paint = paint(random, kCar);
  Body body;
  const double sill_m = 0.28;
  body.push_back(box_part(0, 0, (sill_m + waist_m) / 2, {length_m, width_m, waist_m - sill_m}, body_paint));
  const double glass_m = height_m - 0.1 - waist_m;
  body.push_back(
      box_part(cabin_x, 0, waist_m + glass_m / 2, {cabin_m, width_m - 0.25, glass_m}, surfaces::kCarGlass));
  for (const double x : {-cabin_m / 2, cabin_m / 8, cabin_m / 2}) {  // pillars
    body.push_back(
        box_part(cabin_x + x, 0, waist_m + glass_m / 2, {0.09, width_m - 0.22, glass_m}, body_paint));
  }
  body.push_back(box_part(cabin_x, 0, height_m - 0.05, {cabin_m * 0.9, width_m - 0.3, 0.1}, body_paint));
  for (const double y : {-width_m / 2 - 0.08, width_m / 2 + 0.08}) {  // mirrors
    body.push_back(box_part(cabin_x + cabin_m / 2 - 0.1, y, waist_m + 0.08, {0.1, 0.16, 0.14}, body_paint));
  }
  add_wheels(&body, kCarWheelbase_m, width_m - 0.2, 0.32, kCar);
  return body;
}

Body truck_body(Random* random) {
  const double length_m = random->uniform(5.5, 9.0), height_m = random->uniform(2.5, 3.6);
  const Surface body_paint = paint(random, kTruck);
  const double width_m = 2.3, floor_m = 0.6, cab_m = 1.7;
  const double box_m = length_m - cab_m - 0.2;
  Body body;
  body.push_back(box_part((box_m - length_m) / 2, 0, (floor_m + height_m) / 2,
                          {box_m, width_m, height_m - floor_m}, body_paint));
  body.push_back(
      box_part(length_m / 2 - cab_m / 2, 0, 1.3, {cab_m, width_m - 0.1, 1.6}, paint(random, kTruck)));
  body.push_back(box_part(length_m / 2 - 0.15, 0, 1.9, {0.34, width_m - 0.3, 0.6},
                          of_class(surfaces::kCarGlass, kTruck)));
  add_wheels(&body, length_m * 0.6, width_m - 0.3, 0.45, kTruck);
  return body;
}

Body tractor_body(Random* random) {
  const Surface body_paint = paint(random, kOtherVehicle);
  Body body;
  body.push_back(box_part(0.9, 0, 0.95, {1.5, 0.7, 0.6}, body_paint));
  body.push_back(box_part(-0.4, 0, 0.8, {1.1, 1.1, 0.4}, body_paint));
  body.push_back(box_part(-0.4, 0, 2.05, {1.2, 1.2, 0.08}, body_paint));
  for (const double x : {-0.9, 0.1}) {
    for (const double y : {-0.5, 0.5}) body.push_back(box_part(x, y, 1.5, {0.07, 0.07, 1.05}, body_paint));
  }
  body.push_back({make_capsule({-0.4, 0, 1.0}, {-0.4, 0, 1.5}, 0.2, surfaces::kClothes)});
  body.push_back(box_part(-2.4, 0, 0.75, {1.8, 1.2, 0.5}, body_paint));  // trailer
  add_wheels(&body, 1.8, 1.2, 0.5, kOtherVehicle);
  return body;
}

Body person_body(Random* random) {
  const double height_m = random->uniform(1.55, 1.92), girth = random->uniform(0.9, 1.15);
  const double hip_m = height_m * 0.5, shoulder_m = height_m * 0.81;
  const double stride_m = height_m * 0.8, phase_rad = random->uniform(0, 2 * M_PI);
  Surface clothes = surfaces::kClothes;
  clothes.reflectivity = static_cast<float>(random->uniform(0.1, 0.7));
  Body body;
  const double torso_radius_m = 0.16 * girth;
  body.push_back({make_capsule({0, 0.04, hip_m + torso_radius_m / 2},
                               {0, 0.04, shoulder_m - torso_radius_m / 2}, torso_radius_m, clothes)});
  body.push_back({make_capsule({0, -0.04, hip_m + torso_radius_m / 2},
                               {0, -0.04, shoulder_m - torso_radius_m / 2}, torso_radius_m, clothes)});
  body.push_back({make_ellipsoid({0.02, 0, height_m - 0.12}, {0.1, 0.08, 0.12}, surfaces::kSkin)});
  for (const double side : {-1.0, 1.0}) {
    const double turn = side > 0 ? 0 : M_PI;
    const double leg_radius_m = 0.075 * girth;
    body.push_back(limb({0, side * 0.1, hip_m}, hip_m - leg_radius_m, leg_radius_m, 0.45, phase_rad + turn,
                        stride_m, clothes));
    body.push_back(limb({0, side * (torso_radius_m + 0.08), shoulder_m - 0.05}, height_m * 0.36, 0.05, 0.4,
                        phase_rad + turn + M_PI, stride_m, clothes));
  }
  return body;
}

Body cyclist_body(Random* random) {
  const Surface frame = of_class(surfaces::kMetal, kBicyclist);
  const Surface tyre = of_class(surfaces::kTyre, kBicyclist);
  const Surface clothes = of_class(paint(random, kBicyclist), kBicyclist);
  const Vector3d saddle(-0.25, 0, 0.95), crank(0, 0, 0.3), handlebar(0.45, 0, 1.0);
  Body body;
  for (const double x : {-0.52, 0.52}) {
    body.push_back({make_cylinder_between({x, -0.02, 0.34}, {x, 0.02, 0.34}, 0.34, tyre)});
  }
  body.push_back({make_cylinder_between(saddle, crank, 0.03, frame)});
  body.push_back({make_cylinder_between(crank, handlebar, 0.03, frame)});
  body.push_back({make_cylinder_between(saddle - Vector3d(0, 0, 0.15), handlebar, 0.03, frame)});
  body.push_back({make_cylinder_between(handlebar - Vector3d(0, 0.28, 0), handlebar + Vector3d(0, 0.28, 0),
                                        0.02, frame)});
  body.push_back({make_capsule(saddle + Vector3d(0, 0, 0.1), {0.12, 0, 1.42}, 0.17, clothes)});
  body.push_back(
      {make_ellipsoid({0.22, 0, 1.66}, {0.11, 0.09, 0.13}, of_class(surfaces::kSkin, kBicyclist))});
  for (const double side : {-1.0, 1.0}) {
    body.push_back(
        {make_capsule({0.12, side * 0.2, 1.38}, handlebar + Vector3d(0, side * 0.25, 0), 0.05, clothes)});
    body.push_back(limb({-0.15, side * 0.11, 0.95}, 0.75, 0.07, 0.3, side > 0 ? 0 : M_PI, 3.0, clothes));
  }
  return body;
}

Body door_body(double width_m, double height_m) {
  return {box_part(width_m / 2, 0, height_m / 2, {width_m, 0.05, height_m}, surfaces::kFurniture)};
}

}  // namespace stillmap::simulation
