#pragma once

#include <cstdint>
#include <string>

#include "io/little_endian.hpp"
#include "stillmap/map_contents.hpp"

// The .stillmap file: the complete map. All numbers are little-endian.
//
//   header    "STILLMAP", version u32, voxel size f64 (m), stamp i64 (ns), CRC-32 u32 of all before
//   sections  blocks u32, bytes u32 of what follows the CRC, CRC-32 u32 of blocks, bytes and what follows;
//             then for each block: key 3 x i32, porous cells u64, occupied places 8 x u64, and for each
//             of these 8 bytes: log-odds i16 (1/2048), surface u16, hits u8, idle u8, age u8, and
//             seen_through u8 with came_back as its highest bit; see voxel.hpp
//   end       a section without blocks, which holds the number of blocks u64 and of voxels u64 before it
//
// A section takes at most 1 MiB, so that neither writing nor checking needs the whole map at once.

namespace stillmap::map_archive {

inline constexpr char kMagic[] = "STILLMAP";
inline constexpr std::size_t kMagicBytes = sizeof(kMagic) - 1;
inline constexpr std::uint32_t kVersion = 2;
inline constexpr std::size_t kHeaderBytes = kMagicBytes + 4 + 8 + 8 + 4;
inline constexpr std::size_t kSectionHeadBytes = 4 + 4 + 4;
inline constexpr std::size_t kEndBytes = 8 + 8;
inline constexpr std::size_t kVoxelBytes = 8;
inline constexpr std::size_t kBlockHeadBytes = 3 * 4 + 8 + kBlockVolume / 8;
inline constexpr std::size_t kMostBlockBytes = kBlockHeadBytes + kBlockVolume * kVoxelBytes;
inline constexpr std::size_t kMostSectionBytes = std::size_t{1} << 20;

/// CRC-32 of the bytes, continuing that of the bytes before.
std::uint32_t checksum(const std::string& bytes, std::uint32_t of_before = 0);

void encode(const BlockContents& block, std::string& bytes);
/// False when the bytes end inside of the block.
bool decode(LittleEndianReader& in, BlockContents& block);

}  // namespace stillmap::map_archive
