#pragma once

#include <string>

#include "stillmap/map_contents.hpp"

namespace stillmap {

/// "the map reaches from (-4 -4.8 -0.8) to (5.6 5.6 1.6) m", in whole blocks; or that it is empty.
std::string extent_in_words(const MapPieces& map);

}  // namespace stillmap
