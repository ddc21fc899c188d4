#include "maps/map_extent.hpp"

#include <Eigen/Geometry>
#include <sstream>

namespace stillmap {

std::string extent_in_words(const MapPieces& map) {
  const double block_size_m = map.voxel_size_m * kBlockEdge;
  Eigen::AlignedBox3d extent;
  for (std::vector<BlockContents> blocks; map.next(blocks); blocks.clear())
    for (const BlockContents& block : blocks) {
      if (block.voxels.empty()) continue;
      extent.extend(block.key.cast<double>() * block_size_m);
      extent.extend((block.key.cast<double>().array() + 1).matrix() * block_size_m);
    }
  if (extent.isEmpty()) return "the map is empty";
  std::ostringstream text;
  text << "the map reaches from (" << extent.min().transpose() << ") to (" << extent.max().transpose()
       << ") m";
  return text.str();
}

}  // namespace stillmap
