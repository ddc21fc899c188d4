#pragma once

#include <cstdint>
#include <string>

namespace stillmap {

// SemanticKITTI's labels: class in the low 16 bits, instance in the high 16.

inline constexpr std::uint16_t kVegetation = 70, kMovingPerson = 254;

inline std::uint16_t class_of(std::uint32_t label) {
  return static_cast<std::uint16_t>(label & 0xFFFF);
}
inline std::uint16_t instance_of(std::uint32_t label) {
  return static_cast<std::uint16_t>(label >> 16);
}
/// Unlabelled and outlier: no figure counts them.
inline bool is_ignored(std::uint32_t label) {
  return class_of(label) <= 1;
}
inline bool is_moving(std::uint32_t label) {
  return class_of(label) >= 251 && class_of(label) <= 259;
}
/// "moving person"; "class 7" for numbers that SemanticKITTI does not have.
std::string class_name(std::uint16_t semantic_class);

}  // namespace stillmap
