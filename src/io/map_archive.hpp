#pragma once

#include <string>

#include "stillmap/map_contents.hpp"

namespace stillmap {

/// A whole map as a .stillmap file (map_archive_format.hpp), atomically; and back. Throw std::runtime_error
/// with the path: the reader when the file is foreign, of another version, cut off or damaged.
void write_map_archive(const MapPieces& map, const std::string& path);
/// `path` may also be a folder of tiles that a rolling map left (tile_folder.hpp).
MapContents read_map_archive(const std::string& path);

}  // namespace stillmap
