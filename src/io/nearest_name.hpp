#pragma once

#include <string>
#include <vector>

namespace stillmap {

/// The name of `known` with the fewest edits from `name`; empty when none is near enough to be meant.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

/// The names of all parameters of the method.
std::vector<std::string> parameter_names();

}  // namespace stillmap
