#pragma once

#include <string>
#include <vector>

#include "stillmap/parameters.hpp"

namespace CLI {
class App;
}

namespace stillmap {

/// The options by which a command takes the method's parameters.
struct ParameterOptions {
  std::string config;  ///< YAML file
  std::string preset = "default";
  std::vector<std::string> set;  ///< "name=value", over the file
  int threads = 0;               ///< 0 = not given

  void add_to(CLI::App& command);
  /// Throws std::runtime_error naming what is unknown, of another type or out of range.
  Parameters resolve() const;
};

}  // namespace stillmap
