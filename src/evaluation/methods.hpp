#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "baselines/removal_method.hpp"
#include "stillmap/parameters.hpp"

namespace stillmap {

/// A method to evaluate: its name, and how a fresh one is made for each sequence.
struct MethodChoice {
  std::string name;
  std::function<std::unique_ptr<RemovalMethod>()> make;
};

/// "paper", "default", "octomap", "erasor", "removert" (with the settings of section 2.1) and
/// "octomap_published", "erasor_published", "removert_published" (with their authors' defaults).
std::vector<std::string> method_names();

/// `parameters` are those of the method "default". Throws std::invalid_argument on an unknown name.
MethodChoice choose_method(const std::string& name, const Parameters& parameters);

}  // namespace stillmap
