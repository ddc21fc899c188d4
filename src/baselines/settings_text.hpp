#pragma once

#include <sstream>
#include <string>

#include "core/structure_gates.hpp"

namespace stillmap {

/// Collects a baseline's settings as YAML, one a line.
class SettingsText {
 public:
  template <class Value>
  SettingsText& add(const char* name, const Value& value) {
    text_ << name << ": " << value << '\n';
    return *this;
  }
  SettingsText& add(const char* name, const std::vector<double>& values) {
    text_ << name << ": [";
    for (std::size_t i = 0; i < values.size(); ++i) text_ << (i > 0 ? ", " : "") << values[i];
    text_ << "]\n";
    return *this;
  }
  SettingsText& add(const GateSettings& gates) {
    return add("gate_voxel_support", gates.voxel_support)
        .add("gate_neighbourhood_support", gates.neighbourhood_support)
        .add("gate_grid_support", gates.grid_support)
        .add("gate_height_above_ground_m", gates.height_above_ground_m);
  }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

}  // namespace stillmap
