#include "simulation/structures.hpp"

#include <cmath>

#include "simulation/path.hpp"

namespace stillmap::simulation {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double heading(const Vector2d& from, const Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

/// Calls piece(from, to) for pieces of at most `length_m`, so that long things follow the ground.
template <class Piece>
void in_pieces(const Vector2d& from, const Vector2d& to, double length_m, Piece&& piece) {
  const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / length_m)));
  for (int i = 0; i < count; ++i) {
    piece(from + (to - from) * i / count, from + (to - from) * (i + 1) / count);
  }
}

/// A box that stands upright at a place of a furniture's own frame.
void add_box_in(World* world, const Eigen::Isometry3d& T_map_thing, const Vector3d& at,
                const Vector3d& size_m, const Surface& surface) {
  world->add_box(T_map_thing * pose_at(at.x(), at.y(), at.z()), size_m, surface);
}

}  // namespace

void add_house(World* world, const Vector2d& corner, double width_m, double depth_m, double height_m,
               int side, Random* random) {
  constexpr double kRecess_m = 0.25, kWindowWidth_m = 1.2, kWindowHeight_m = 1.4, kBelowGround_m = 1.0;
  const double ground_m = world->ground.height_m(corner.x() + width_m / 2, corner.y());
  const auto box = [&](double x, double inward_m, double z, const Vector3d& size_m, const Surface& surface) {
    world->add_box(pose_at(corner.x() + x, corner.y() + side * inward_m, ground_m + z), size_m, surface);
  };
  // The house behind its front; the front is what is left around the windows.
  box(width_m / 2, kRecess_m + depth_m / 2, height_m / 2 - kBelowGround_m / 2,
      {width_m, depth_m, height_m + kBelowGround_m}, surfaces::kFacade);
  const int axes = std::max(1, static_cast<int>(width_m / random->uniform(2.2, 3.2)));
  const double pitch_m = width_m / axes, storey_m = 3.0;
  const int storeys = std::max(1, static_cast<int>(height_m / storey_m));
  const double pier_m = pitch_m - kWindowWidth_m;
  for (int i = 0; i <= axes; ++i) {
    const double pier_width_m = (i == 0 || i == axes) ? pier_m / 2 : pier_m;
    const double x = i == 0 ? pier_width_m / 2 : (i == axes ? width_m - pier_width_m / 2 : i * pitch_m);
    box(x, kRecess_m / 2, height_m / 2 - kBelowGround_m / 2,
        {pier_width_m, kRecess_m, height_m + kBelowGround_m}, surfaces::kFacade);
  }
  for (int storey = 0; storey < storeys; ++storey) {
    const double window_m = storey * storey_m + 0.9;
    const double below_m = storey == 0 ? window_m + kBelowGround_m : storey_m - kWindowHeight_m;
    box(width_m / 2, kRecess_m / 2, window_m - below_m / 2, {width_m, kRecess_m, below_m}, surfaces::kFacade);
    for (int i = 0; i < axes; ++i) {
      box((i + 0.5) * pitch_m, kRecess_m - 0.01, window_m + kWindowHeight_m / 2,
          {kWindowWidth_m, 0.04, kWindowHeight_m}, surfaces::kWindow);
    }
  }
  const double top_m = (storeys - 1) * storey_m + 0.9 + kWindowHeight_m;
  box(width_m / 2, kRecess_m / 2, (top_m + height_m) / 2, {width_m, kRecess_m, height_m - top_m},
      surfaces::kFacade);
}

void add_wall(World* world, const Vector2d& from, const Vector2d& to, double thickness_m, double height_m,
              const Surface& surface, double from_height_m) {
  const Vector2d middle = (from + to) / 2;
  const double foot_m = world->ground.height_m(middle.x(), middle.y()) + from_height_m;
  const double below_m = from_height_m > 0 ? 0.0 : 0.3;
  world->add_box(pose_at(middle.x(), middle.y(), foot_m + (height_m - below_m) / 2, heading(from, to)),
                 {(to - from).norm(), thickness_m, height_m + below_m}, surface);
}

void add_fence(World* world, const Vector2d& from, const Vector2d& to, double height_m) {
  in_pieces(from, to, 2.0, [&](const Vector2d& a, const Vector2d& b) {
    const double at_a = world->ground.height_m(a.x(), a.y()), at_b = world->ground.height_m(b.x(), b.y());
    world->add_cylinder(pose_at(a.x(), a.y(), at_a + height_m / 2), 0.05, height_m, surfaces::kFence);
    for (const double share : {0.35, 0.65, 0.95}) {
      world->add(make_cylinder_between({a.x(), a.y(), at_a + share * height_m},
                                       {b.x(), b.y(), at_b + share * height_m}, 0.03, surfaces::kFence));
    }
  });
}

void add_guard_rail(World* world, const Vector2d& from, const Vector2d& to) {
  in_pieces(from, to, 4.0, [&](const Vector2d& a, const Vector2d& b) {
    add_wall(world, a, b, 0.08, 0.31, surfaces::kFence, 0.45);
    const double ground_m = world->ground.height_m(a.x(), a.y());
    world->add_box(pose_at(a.x(), a.y(), ground_m + 0.35), {0.1, 0.1, 0.7}, surfaces::kFence);
  });
}

void add_kerb(World* world, const Vector2d& from, const Vector2d& to, double height_m) {
  constexpr double kWidth_m = 0.15;
  in_pieces(from, to, 2.0, [&](const Vector2d& a, const Vector2d& b) {
    const Vector2d middle = (a + b) / 2;
    const double top_m = world->ground.bare_height_m(middle.x(), middle.y()) + height_m;
    world->add_box(pose_at(middle.x(), middle.y(), top_m - 0.2, heading(a, b)),
                   {(b - a).norm(), kWidth_m, 0.4}, surfaces::kKerb);
  });
}

void add_pole(World* world, const Vector2d& at, double radius_m, double height_m) {
  const double ground_m = world->ground.height_m(at.x(), at.y());
  world->add_cylinder(pose_at(at.x(), at.y(), ground_m + height_m / 2), radius_m, height_m, surfaces::kPole);
}

void add_sign(World* world, const Vector2d& at, double facing_rad) {
  add_pole(world, at, 0.035, 2.8);
  const double ground_m = world->ground.height_m(at.x(), at.y());
  world->add_box(pose_at(at.x(), at.y(), ground_m + 2.45, facing_rad) * pose_at(0.05, 0, 0), {0.02, 0.6, 0.6},
                 surfaces::kSign);
}

void add_wire(World* world, const Vector3d& from, const Vector3d& to, double sag_m) {
  constexpr int kPieces = 8;
  const auto at = [&](int i) -> Vector3d {
    const double share = static_cast<double>(i) / kPieces;
    return from + share * (to - from) - Vector3d(0, 0, 4 * sag_m * share * (1 - share));
  };
  for (int i = 0; i < kPieces; ++i) {
    world->add(make_cylinder_between(at(i), at(i + 1), 0.012, surfaces::kPole));
  }
}

void add_column(World* world, const Vector2d& at, double radius_m, double height_m) {
  Surface stone = surfaces::kFacade;
  stone.reflectivity = 0.5F;
  const double ground_m = world->ground.height_m(at.x(), at.y());
  world->add_cylinder(pose_at(at.x(), at.y(), ground_m + height_m / 2), radius_m, height_m, stone);
}

void add_bench(World* world, const Vector2d& at, double yaw_rad) {
  const Eigen::Isometry3d T_map_bench = on_ground(world->ground, at, yaw_rad);
  add_box_in(world, T_map_bench, {0, 0, 0.43}, {0.45, 1.8, 0.06}, surfaces::kFurniture);
  add_box_in(world, T_map_bench, {-0.2, 0, 0.7}, {0.05, 1.8, 0.35}, surfaces::kFurniture);
  for (const double y : {-0.75, 0.75}) {
    add_box_in(world, T_map_bench, {0, y, 0.2}, {0.4, 0.08, 0.4}, surfaces::kFurniture);
  }
}

void add_table(World* world, const Vector2d& at, double yaw_rad) {
  const Eigen::Isometry3d T_map_table = on_ground(world->ground, at, yaw_rad);
  add_box_in(world, T_map_table, {0, 0, 0.73}, {1.5, 0.8, 0.04}, surfaces::kFurniture);
  for (const double x : {-0.7, 0.7}) {
    for (const double y : {-0.35, 0.35}) {
      add_box_in(world, T_map_table, {x, y, 0.36}, {0.05, 0.05, 0.72}, surfaces::kFurniture);
    }
  }
}

}  // namespace stillmap::simulation
