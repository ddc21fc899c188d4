#pragma once

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace stillmap {

/// As many numbers as `meaning` names, as "1.5 -2 0". Throws std::runtime_error naming the option.
inline std::vector<double> coordinates(const std::string& text, std::size_t count, const std::string& option,
                                       const std::string& meaning) {
  std::istringstream stream(text);
  std::vector<double> numbers(count);
  for (double& number : numbers) stream >> number;
  std::string rest;
  if (!stream || stream >> rest)
    throw std::runtime_error(option + " '" + text + "': give " + meaning +
                             " in metres, as one word in quotes");
  return numbers;
}

}  // namespace stillmap
