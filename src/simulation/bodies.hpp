#pragma once

#include "simulation/random.hpp"
#include "simulation/world.hpp"

namespace stillmap::simulation {

// Bodies of movers and of what stands about: x ahead, z up, origin on the ground below the middle. Sizes and
// colours vary with the random numbers.

Body car_body(Random* random);
Body truck_body(Random* random);  ///< or van or bus
Body tractor_body(Random* random);
Body person_body(Random* random);  ///< legs and arms swing as it walks
Body cyclist_body(Random* random);
Body door_body(double width_m, double height_m);  ///< hinge at the origin, the leaf along +x

inline constexpr double kCarWheelbase_m = 2.7;
inline constexpr double kTruckWheelbase_m = 4.5;

}  // namespace stillmap::simulation
