#pragma once

#include <string>

#include "stillmap/parameters.hpp"

namespace stillmap {

/// Reads a YAML map of parameter names. The key `preset` names the base for those not given. Throws
/// std::runtime_error naming the file and the key when one is unknown, of another type or out of range.
Parameters load_parameters(const std::string& yaml_file);

/// Sets one parameter from YAML text ("0.2", "[2.5, 2.0]"). The range is not checked: see check_parameters().
/// Throws std::runtime_error when the name is unknown or the text is of another type.
void set_parameter(Parameters& parameters, const std::string& name, const std::string& yaml_text);

/// Throws std::runtime_error with every problem; `source` says where the values came from.
void check_parameters(const Parameters& parameters, const std::string& source);

/// Every parameter with its meaning, unit and range as a comment; load_parameters() reads it back exactly.
std::string to_yaml(const Parameters& parameters);

}  // namespace stillmap
