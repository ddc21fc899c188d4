#pragma once

#include <string>

#include "maps/map_diff.hpp"

namespace stillmap {

/// The changes as a table for a person, and as .csv text: what, middle, extent, voxels.
std::string table_of(const MapDiff& diff);
std::string csv_of(const MapDiff& diff);

/// The static cloud of one kind of changes, to be saved or published.
MapSnapshot snapshot_of(const std::vector<Change>& changes, const MapDiff& diff);

/// Draws both maps from above as .png: grey is the same, green appeared, red went. Returns what the picture
/// shows, in words. Throws std::invalid_argument when there is nothing to draw.
std::string save_diff_picture(const MapDiff& diff, const std::string& path);

}  // namespace stillmap
