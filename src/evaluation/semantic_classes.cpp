#include "evaluation/semantic_classes.hpp"

#include <map>

namespace stillmap {

std::string class_name(std::uint16_t semantic_class) {
  static const std::map<std::uint16_t, const char*> kNames = {{0, "unlabelled"},
                                                              {1, "outlier"},
                                                              {9, "static"},
                                                              {10, "car"},
                                                              {11, "bicycle"},
                                                              {13, "bus"},
                                                              {15, "motorcycle"},
                                                              {16, "on rails"},
                                                              {18, "truck"},
                                                              {20, "other vehicle"},
                                                              {30, "person"},
                                                              {31, "bicyclist"},
                                                              {32, "motorcyclist"},
                                                              {40, "road"},
                                                              {44, "parking"},
                                                              {48, "sidewalk"},
                                                              {49, "other ground"},
                                                              {50, "building"},
                                                              {51, "fence"},
                                                              {52, "other structure"},
                                                              {60, "lane marking"},
                                                              {70, "vegetation"},
                                                              {71, "trunk"},
                                                              {72, "terrain"},
                                                              {80, "pole"},
                                                              {81, "traffic sign"},
                                                              {99, "other object"},
                                                              {251, "moving"},
                                                              {252, "moving car"},
                                                              {253, "moving bicyclist"},
                                                              {254, "moving person"},
                                                              {255, "moving motorcyclist"},
                                                              {256, "moving on rails"},
                                                              {257, "moving bus"},
                                                              {258, "moving truck"},
                                                              {259, "moving other vehicle"}};
  const auto name = kNames.find(semantic_class);
  return name != kNames.end() ? name->second : "class " + std::to_string(semantic_class);
}

}  // namespace stillmap
