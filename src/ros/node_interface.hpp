#pragma once

#include <string>
#include <vector>

namespace stillmap {

/// A topic or service of the node, for the reference; a test compares the list with what the node advertises.
struct Endpoint {
  std::string name;  ///< below the node's own: "static_points" is /stillmap/static_points
  std::string type;
  std::string help;
};

const std::vector<Endpoint>& published_topics();
const std::vector<Endpoint>& offered_services();

}  // namespace stillmap
