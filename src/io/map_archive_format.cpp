#include "io/map_archive_format.hpp"

#include <zlib.h>

namespace stillmap::map_archive {
namespace {

Voxel decode_voxel(LittleEndianReader& in) {
  Voxel voxel;
  voxel.log_odds_fixed = in.get<std::int16_t>();
  voxel.surface = in.get<std::uint16_t>();
  voxel.hits = in.get<std::uint8_t>();
  voxel.idle = in.get<std::uint8_t>();
  voxel.age = in.get<std::uint8_t>();
  const auto flags = in.get<std::uint8_t>();
  voxel.seen_through = flags & 0x3F;
  voxel.moved_in = flags >> 6 & 1;
  voxel.came_back = flags >> 7;
  return voxel;
}

}  // namespace

std::uint32_t checksum(const std::string& bytes, std::uint32_t of_before) {
  return static_cast<std::uint32_t>(
      crc32(of_before, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

void encode(const BlockContents& block, std::string& bytes) {
  LittleEndianWriter out(bytes);
  for (int axis = 0; axis < 3; ++axis) out.put(static_cast<std::int32_t>(block.key[axis]));
  out.put(block.porous);
  for (const std::uint64_t word : block.occupied) out.put(word);
  for (const Voxel& voxel : block.voxels) {
    out.put(voxel.log_odds_fixed);
    out.put(voxel.surface);
    out.put(voxel.hits);
    out.put(voxel.idle);
    out.put(voxel.age);
    out.put(static_cast<std::uint8_t>(voxel.seen_through | voxel.moved_in << 6 | voxel.came_back << 7));
  }
}

bool decode(LittleEndianReader& in, BlockContents& block) {
  if (in.rest() < kBlockHeadBytes) return false;
  for (int axis = 0; axis < 3; ++axis) block.key[axis] = in.get<std::int32_t>();
  block.porous = in.get<std::uint64_t>();
  std::size_t voxels = 0;
  for (std::uint64_t& word : block.occupied) {
    word = in.get<std::uint64_t>();
    voxels += static_cast<std::size_t>(__builtin_popcountll(word));
  }
  if (in.rest() < voxels * kVoxelBytes) return false;
  block.voxels.reserve(voxels);
  for (std::size_t i = 0; i < voxels; ++i) block.voxels.push_back(decode_voxel(in));
  return true;
}

}  // namespace stillmap::map_archive
