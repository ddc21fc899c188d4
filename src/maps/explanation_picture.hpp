#pragma once

#include <string>

#include "stillmap/explanation.hpp"
#include "stillmap/map_snapshot.hpp"

namespace stillmap {

/// Saves a .png of the map around a place from above, of what lies about as high as it, with the ray of each
/// kept scan that says anything: to where it ended, as rviz shows it. Returns what it shows in words.
std::string save_explanation_picture(const Explanation& explanation, const MapSnapshot& map,
                                     const std::string& path);

}  // namespace stillmap
