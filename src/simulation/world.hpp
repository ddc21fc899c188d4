#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "simulation/ground.hpp"
#include "simulation/shape.hpp"

namespace stillmap::simulation {

inline constexpr double kNever_s = std::numeric_limits<double>::infinity();

/// How a leaf moves in the wind; amplitude 0 = stiff.
struct Sway {
  float amplitude_m = 0;
  float frequency_hz = 0.5F;
  float phase_rad = 0;

  Eigen::Vector3d displacement_m(double time_s) const;
  double reach_m() const { return 1.2 * static_cast<double>(amplitude_m); }  ///< largest displacement
};

/// Something of the world that stays.
struct Fixture {
  Shape shape;
  Sway sway;
  std::uint16_t instance = 0;
};

/// A limb swings about the body's y axis as the body gets on; amplitude 0 = part of the trunk.
struct Swing {
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();  ///< body frame
  double amplitude_rad = 0;
  double phase_rad = 0;
  double stride_m = 1.4;  ///< way of one full swing
};

struct Part {
  Shape shape;  ///< in the body frame: x ahead, z up, origin on the ground
  Swing swing = {};
};
using Body = std::vector<Part>;

struct MoverPose {
  Eigen::Isometry3d T_map_body;
  double distance_m = 0;  ///< travelled so far; what swings the limbs
};

struct Mover {
  Body body;
  std::function<MoverPose(double time_s)> motion;
  double first_move_s = 0;  ///< kNever_s = it never does
  std::uint16_t class_moving = kMovingOther;
  std::uint16_t class_standing = kOther;  ///< before it first moves
  std::uint16_t instance = 0;             ///< set by World::add_mover
};

/// Everything there is to see: ground, things that stay, things that move.
class World {
 public:
  Ground ground;

  void add(const Shape& shape, const Sway& sway = {}, std::uint16_t instance = 0);
  void add_box(const Eigen::Isometry3d& T_map_box, const Eigen::Vector3d& size_m, const Surface& surface);
  void add_cylinder(const Eigen::Isometry3d& T_map_cylinder, double radius_m, double height_m,
                    const Surface& surface);
  /// Level ground at this height, as far as one can see.
  void add_ground(double height_m, const Surface& surface);
  /// A body that stays, as one instance.
  void add_standing(const Body& body, const Eigen::Isometry3d& T_map_body);
  /// Gives the mover its instance number and returns it.
  std::uint16_t add_mover(Mover mover);

  const std::vector<Fixture>& fixtures() const { return fixtures_; }
  const std::vector<Mover>& movers() const { return movers_; }

 private:
  std::uint16_t next_instance();

  std::vector<Fixture> fixtures_;
  std::vector<Mover> movers_;
  std::uint16_t instance_count_ = 0;
};

}  // namespace stillmap::simulation
