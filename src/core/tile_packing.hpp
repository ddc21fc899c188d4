#pragma once

#include <string>
#include <vector>

#include "stillmap/map_contents.hpp"

namespace stillmap {

/// The blocks of one tile in a third of their memory, losslessly; and back. Throws std::runtime_error when
/// the bytes are not from pack().
std::string pack(const std::vector<BlockContents>& blocks);
std::vector<BlockContents> unpack(const std::string& packed);

}  // namespace stillmap
