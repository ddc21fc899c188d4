#pragma once

#include <string>

#include "stillmap/map_contents.hpp"

namespace stillmap {

/// Saves the map in the form that the extension names: save_map()'s, or a height picture for .png. Returns
/// what was saved, in words. Throws std::runtime_error or std::invalid_argument.
std::string export_map(const MapContents& map, const Decision& decision, const std::string& path);

}  // namespace stillmap
