#include "io/nearest_name.hpp"

#include <algorithm>
#include <numeric>

#include "stillmap/parameters.hpp"

namespace stillmap {
namespace {

/// Levenshtein's distance: insertions, deletions and replacements.
std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t fewest = name.size() / 2 + 1;  // more edits: another word
  for (const std::string& candidate : known) {
    const std::size_t distance = edits(name, candidate);
    if (distance < fewest) {
      fewest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::vector<std::string> parameter_names() {
  std::vector<std::string> names;
  const Parameters parameters;
  visit_parameters(parameters, [&](const ParameterInfo& info, const auto&) { names.push_back(info.name); });
  return names;
}

}  // namespace stillmap
