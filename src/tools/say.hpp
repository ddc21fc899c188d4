#pragma once

#include <iostream>
#include <string>

namespace stillmap {

/// A message for the person at the terminal, beside what a command prints.
inline void say(const std::string& message) {
  std::cerr << "stillmap: " << message << std::endl;
}

}  // namespace stillmap
