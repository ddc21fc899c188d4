#include "maps/map_merge.hpp"

#include <tsl/robin_map.h>

#include <algorithm>
#include <stdexcept>

#include "stillmap/voxel_sum.hpp"

namespace stillmap {
namespace {

BlockContents sum(const BlockContents& a, const BlockContents& b, LogOddsBounds bounds) {
  BlockContents block;
  block.key = a.key;
  block.porous = a.porous | b.porous;
  auto of_a = a.voxels.begin(), of_b = b.voxels.begin();
  for (int word = 0; word < static_cast<int>(block.occupied.size()); ++word) {
    block.occupied[word] = a.occupied[word] | b.occupied[word];
    for (std::uint64_t bits = block.occupied[word]; bits != 0; bits &= bits - 1) {
      const std::uint64_t lowest = bits & (~bits + 1);
      const bool in_a = (a.occupied[word] & lowest) != 0, in_b = (b.occupied[word] & lowest) != 0;
      if (in_a && in_b)
        block.voxels.push_back(sum(*of_a++, *of_b++, bounds.min, bounds.max));
      else
        block.voxels.push_back(in_a ? *of_a++ : *of_b++);
    }
  }
  return block;
}

}  // namespace

void merge(MapContents& into, const MapContents& other, LogOddsBounds bounds) {
  if (into.voxel_size_m != other.voxel_size_m)
    throw std::invalid_argument("voxels of " + std::to_string(into.voxel_size_m) + " m and of " +
                                std::to_string(other.voxel_size_m) +
                                " m do not go together; make both maps with one voxel_size_m");
  tsl::robin_map<std::uint64_t, std::size_t, BlockKeyHash> index;
  for (std::size_t i = 0; i < into.blocks.size(); ++i) index.emplace(packed(into.blocks[i].key), i);
  for (const BlockContents& block : other.blocks) {
    const auto found = index.find(packed(block.key));
    if (found == index.end())
      into.blocks.push_back(block);
    else
      into.blocks[found->second] = sum(into.blocks[found->second], block, bounds);
  }
  into.stamp_ns = std::max(into.stamp_ns, other.stamp_ns);
}

}  // namespace stillmap
