#include "tile_packing.hpp"

#include <zstd.h>

#include <array>
#include <cstring>
#include <stdexcept>

namespace stillmap {
namespace {

static_assert(std::is_trivially_copyable_v<Voxel>);
constexpr int kLevel = 2;  // 1 and 3 give 1 % more and 2 % less, in 0.9 and 1.3 times the time

/// What comes first in the bytes to compress.
struct Counts {
  std::uint32_t blocks = 0, voxels = 0;
};

/// Each byte of the voxels, and each field of the blocks, has a column of its own: what is alike lies
/// together.
struct Columns {
  static constexpr std::size_t kBlockBytes = 3 * 4 + sizeof(CellMask) + kBlockVolume / 8;
  static std::size_t bytes(Counts counts) {
    return sizeof(Counts) + counts.blocks * kBlockBytes + counts.voxels * sizeof(Voxel);
  }

  Columns(char* raw, Counts counts) {
    keys = raw + sizeof(Counts);
    porous = keys + counts.blocks * 3 * std::size_t{4};
    occupied = porous + counts.blocks * sizeof(CellMask);
    for (std::size_t i = 0; i < sizeof(Voxel); ++i)
      voxel_bytes[i] = occupied + counts.blocks * std::size_t{kBlockVolume / 8} + i * counts.voxels;
  }

  char *keys, *porous, *occupied;
  std::array<char*, sizeof(Voxel)> voxel_bytes;
};

template <class T>
void write(char*& column, const T& value) {
  std::memcpy(column, &value, sizeof(T));
  column += sizeof(T);
}
template <class T>
void read(char*& column, T& value) {
  std::memcpy(&value, column, sizeof(T));
  column += sizeof(T);
}

/// Neighbours were seen at about the same times: the differences are small numbers, and compress better.
struct TimeSteps {
  std::uint8_t last_idle = 0;

  void shrink(Voxel& voxel) {
    const std::uint8_t idle = voxel.idle;
    voxel.age = static_cast<std::uint8_t>(voxel.age - idle);
    voxel.idle = static_cast<std::uint8_t>(idle - last_idle);
    last_idle = idle;
  }
  void grow(Voxel& voxel) {
    voxel.idle = last_idle = static_cast<std::uint8_t>(voxel.idle + last_idle);
    voxel.age = static_cast<std::uint8_t>(voxel.age + voxel.idle);
  }
};

std::string decompressed(const std::string& packed) {
  const unsigned long long bytes = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (bytes == ZSTD_CONTENTSIZE_ERROR || bytes == ZSTD_CONTENTSIZE_UNKNOWN)
    throw std::runtime_error("a packed tile is damaged");
  std::string raw(bytes, '\0');
  const std::size_t got = ZSTD_decompress(raw.data(), raw.size(), packed.data(), packed.size());
  if (ZSTD_isError(got) != 0 || got != raw.size()) throw std::runtime_error("a packed tile is damaged");
  return raw;
}

}  // namespace

std::string pack(const std::vector<BlockContents>& blocks) {
  Counts counts{static_cast<std::uint32_t>(blocks.size()), 0};
  for (const BlockContents& block : blocks) counts.voxels += static_cast<std::uint32_t>(block.voxels.size());
  std::string raw(Columns::bytes(counts), '\0');
  std::memcpy(raw.data(), &counts, sizeof(counts));
  Columns columns(raw.data(), counts);
  BlockKey last(0, 0, 0);
  TimeSteps times;
  for (const BlockContents& block : blocks) {
    for (int axis = 0; axis < 3; ++axis)
      write(columns.keys, static_cast<std::int32_t>(block.key[axis] - last[axis]));
    last = block.key;
    write(columns.porous, block.porous);
    write(columns.occupied, block.occupied);
    for (Voxel voxel : block.voxels) {
      times.shrink(voxel);
      char bytes[sizeof(Voxel)];
      std::memcpy(bytes, &voxel, sizeof(Voxel));
      for (std::size_t i = 0; i < sizeof(Voxel); ++i) *columns.voxel_bytes[i]++ = bytes[i];
    }
  }
  std::string packed(ZSTD_compressBound(raw.size()), '\0');
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), kLevel);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(ZSTD_getErrorName(size));
  return packed.substr(0, size);  // a copy of just the size
}

std::vector<BlockContents> unpack(const std::string& packed) {
  std::string raw = decompressed(packed);
  Counts counts;
  std::memcpy(&counts, raw.data(), sizeof(counts));
  if (raw.size() != Columns::bytes(counts)) throw std::runtime_error("a packed tile is damaged");
  Columns columns(raw.data(), counts);
  std::vector<BlockContents> blocks(counts.blocks);
  BlockKey last(0, 0, 0);
  TimeSteps times;
  for (BlockContents& block : blocks) {
    std::int32_t step[3];
    read(columns.keys, step);
    block.key = last = last + BlockKey(step[0], step[1], step[2]);
    read(columns.porous, block.porous);
    read(columns.occupied, block.occupied);
    std::size_t voxels = 0;
    for (const std::uint64_t word : block.occupied)
      voxels += static_cast<std::size_t>(__builtin_popcountll(word));
    block.voxels.resize(voxels);
    for (Voxel& voxel : block.voxels) {
      char bytes[sizeof(Voxel)];
      for (std::size_t i = 0; i < sizeof(Voxel); ++i) bytes[i] = *columns.voxel_bytes[i]++;
      std::memcpy(&voxel, bytes, sizeof(Voxel));
      times.grow(voxel);
    }
  }
  return blocks;
}

}  // namespace stillmap
