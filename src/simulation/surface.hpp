#pragma once

#include <cstdint>

namespace stillmap::simulation {

/// What a thing is (SemanticKITTI class) and how it answers a laser.
struct Surface {
  std::uint16_t semantic_class;
  float reflectivity;        ///< 0 to 1
  float return_probability;  ///< of a near, perpendicular ray: dark paint and glass swallow some
  float roughness_m = 0;     ///< ground only: height of grass or gravel above the ground's own height
  float transparency = 0;    ///< probability that a ray goes through to what is behind
};

/// SemanticKITTI classes of the things that a mover may be.
inline constexpr std::uint16_t kCar = 10, kTruck = 18, kOtherVehicle = 20, kPerson = 30, kBicyclist = 31;
inline constexpr std::uint16_t kMovingCar = 252, kMovingBicyclist = 253, kMovingPerson = 254;
inline constexpr std::uint16_t kMovingTruck = 258, kMovingOther = 259;
inline constexpr std::uint16_t kBuilding = 50, kOther = 99;

namespace surfaces {
inline constexpr Surface kRoad{40, 0.18F, 1.0F, 0.0F};
inline constexpr Surface kParking{44, 0.2F, 1.0F, 0.0F};
inline constexpr Surface kSidewalk{48, 0.3F, 1.0F, 0.0F};
inline constexpr Surface kKerb{48, 0.35F, 1.0F};
inline constexpr Surface kGrass{72, 0.4F, 0.98F, 0.12F};
inline constexpr Surface kForestFloor{72, 0.35F, 0.97F, 0.18F};
inline constexpr Surface kFloor{48, 0.3F, 0.98F, 0.0F};
inline constexpr Surface kFacade{50, 0.4F, 1.0F};
inline constexpr Surface kWindow{50, 0.15F, 0.3F};
inline constexpr Surface kPane{50, 0.15F, 0.3F, 0.0F, 0.6F};  ///< a window seen from inside
inline constexpr Surface kWall{50, 0.6F, 1.0F};
inline constexpr Surface kFence{51, 0.35F, 0.98F};
inline constexpr Surface kLeaf{70, 0.45F, 0.95F};
inline constexpr Surface kTrunk{71, 0.35F, 1.0F};
inline constexpr Surface kPole{80, 0.4F, 1.0F};
inline constexpr Surface kSign{81, 0.9F, 1.0F};
inline constexpr Surface kFurniture{99, 0.4F, 0.98F};
inline constexpr Surface kClothes{30, 0.35F, 0.97F};
inline constexpr Surface kSkin{30, 0.5F, 0.98F};
inline constexpr Surface kTyre{10, 0.08F, 0.9F};
inline constexpr Surface kCarGlass{10, 0.1F, 0.6F, 0.0F, 0.5F};
inline constexpr Surface kMetal{99, 0.5F, 0.98F};
}  // namespace surfaces

}  // namespace stillmap::simulation
