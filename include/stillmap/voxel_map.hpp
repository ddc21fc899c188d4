#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <cstdint>
#include <vector>

#include "stillmap/cell_mask.hpp"
#include "stillmap/map_contents.hpp"
#include "stillmap/voxel.hpp"
#include "stillmap/voxel_key.hpp"

namespace stillmap {

/// One bit for each place in a block.
using PlaceMask = std::array<std::uint64_t, kBlockVolume / 64>;

/// 8 x 8 x 8 voxels, of which only those ever hit are stored, by ascending place.
class VoxelBlock {
 public:
  explicit VoxelBlock(const BlockKey& key) : key_(key) {}

  const BlockKey& key() const { return key_; }
  bool contains(int place) const { return occupied_[place >> 6] >> (place & 63) & 1; }
  /// Index of the voxel at `place` among the stored ones; it must be contained.
  int rank(int place) const {
    const std::uint64_t below = occupied_[place >> 6] & ((std::uint64_t{1} << (place & 63)) - 1);
    return before_[place >> 6] + __builtin_popcountll(below);
  }
  Voxel& at(int place) { return voxels_[rank(place)]; }
  const Voxel& at(int place) const { return voxels_[rank(place)]; }
  /// The voxel of a rank.
  Voxel& stored(int rank) { return voxels_[rank]; }
  const Voxel& stored(int rank) const { return voxels_[rank]; }
  Voxel& find_or_create(int place, bool& created) {
    created = !contains(place);
    if (created) create(place);
    return at(place);
  }
  /// Makes the voxels at these places that are not there, and says which.
  PlaceMask create(const PlaceMask& places);

  std::size_t size() const { return voxels_.size(); }
  /// Calls visit(place, voxel) by ascending place.
  template <class Visitor>
  void for_each(Visitor&& visit) {
    for_each_of(*this, visit);
  }
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    for_each_of(*this, visit);
  }

  /// Has the processor fetch the block itself, and its voxels: for loops over blocks that lie apart.
  void prefetch() const {
    constexpr std::size_t kLine = 64;
    for (std::size_t at = 0; at < sizeof(VoxelBlock); at += kLine)
      __builtin_prefetch(reinterpret_cast<const char*>(this) + at);
  }
  void prefetch_voxels() const {
    constexpr std::size_t kInALine = 8;
    for (std::size_t i = 0; i < voxels_.size(); i += kInALine) __builtin_prefetch(&voxels_[i], 1);
  }

  /// Brings Voxel::idle and Voxel::age up to `scan`.
  void age(std::uint32_t scan);

  /// The voxel at `place`, which must be contained, as of `scan`.
  Voxel as_of(int place, std::uint32_t scan) const;
  /// A copy of it as of `scan`, and the way back; what restore() gets must have no problem().
  BlockContents contents(std::uint32_t scan) const;
  void restore(const BlockContents& contents, std::uint32_t scan);

  std::uint32_t hit_scan = 0;  ///< last scan that hit a voxel of it
  CellMask standing = 0;       ///< of that scan: cells where it hit surface known to stand
  CellMask porous = 0;  ///< of that scan: cells with surface that was hit again after it was seen through
  std::uint32_t moving_scan = 0;  ///< last scan that saw something move in it
  CellMask moving = 0;            ///< of that scan: the cells where it did

 private:
  void create(int place);
  void count_before();
  template <class BlockT, class Visitor>
  static void for_each_of(BlockT& block, Visitor&& visit) {
    auto* voxel = block.voxels_.data();
    for (int word = 0; word < kWords; ++word)
      for (std::uint64_t bits = block.occupied_[word]; bits != 0; bits &= bits - 1)
        visit(word * 64 + __builtin_ctzll(bits), *voxel++);
  }

  static constexpr int kWords = kBlockVolume / 64;
  BlockKey key_;
  std::uint32_t aged_scan_ = 0;
  PlaceMask occupied_{};
  std::array<std::uint16_t, kWords> before_{};  ///< stored voxels in the words before
  std::vector<Voxel> voxels_;
};

/// The blocks of one tile, in the order in which they came, with their keys: most need no look at the block.
struct BlockEntry {
  BlockKey key;
  std::uint32_t index;
};
using BlockTile = std::vector<BlockEntry>;

/// Sparse hashed voxels in blocks. A block keeps its index and address until its tile is erased; the index
/// may then be given to another block.
class VoxelMap {
 public:
  explicit VoxelMap(double voxel_size_m) : voxel_size_m_(voxel_size_m), inverse_(1.0 / voxel_size_m) {}

  double voxel_size_m() const { return voxel_size_m_; }
  double inverse_voxel_size() const { return inverse_; }
  double block_size_m() const { return voxel_size_m_ * kBlockEdge; }

  VoxelKey key_of(const Eigen::Vector3d& point_map_m) const { return voxel_key(point_map_m, inverse_); }
  Eigen::Vector3d center_of(const VoxelKey& key) const {
    return (key.cast<double>().array() + 0.5) * voxel_size_m_;
  }

  /// Index of the block, or -1.
  std::int64_t find_block(const BlockKey& key) const {
    const auto it = index_.find(packed(key));
    return it == index_.end() ? std::int64_t{-1} : std::int64_t{it->second};
  }
  std::uint32_t find_or_create_block(const BlockKey& key);
  const Voxel* find(const VoxelKey& key) const {
    const std::int64_t block = find_block(block_key(key));
    if (block < 0) return nullptr;
    const VoxelBlock& found = this->block(static_cast<std::uint32_t>(block));
    return found.contains(place_in_block(key)) ? &found.at(place_in_block(key)) : nullptr;
  }

  /// Indices in use and those of erased blocks, which are empty.
  std::size_t block_count() const { return block_count_; }
  VoxelBlock& block(std::uint32_t index) { return chunks_[index >> kChunkShift][index & (kChunk - 1)]; }
  const VoxelBlock& block(std::uint32_t index) const {
    return chunks_[index >> kChunkShift][index & (kChunk - 1)];
  }
  std::size_t voxel_count() const { return voxel_count_; }
  /// To be told of each voxel that was made in a block.
  void count_created(std::size_t voxels) { voxel_count_ += voxels; }
  /// Puts a block in as of `scan`, over the one with its key.
  void restore(const BlockContents& contents, std::uint32_t scan);

  /// All tiles of which some part, seen from above, lies within `reach_m` of a place; always in the same
  /// order. Valid until the next block is made.
  void find_near(const Eigen::Vector3d& center_map_m, double reach_m,
                 std::vector<const BlockTile*>& tiles) const;
  /// nullptr when the tile has no blocks.
  const BlockTile* tile(const TileKey& key) const {
    const auto it = tiles_.find(packed_tile(key));
    return it == tiles_.end() ? nullptr : &it->second;
  }
  void erase_tile(const TileKey& key);

  /// Calls visit(key) for each tile, of the map or not, of which some part seen from above lies within
  /// `reach_m`; for none around a place that no voxel can have.
  template <class Visitor>
  void for_each_tile_near(const Eigen::Vector3d& center_map_m, double reach_m, Visitor&& visit) const {
    const double tile_m = block_size_m() * kTileEdge, reach = reach_m / tile_m;
    const Eigen::Array2d center = center_map_m.head<2>().array() / tile_m;
    if (!((center_map_m.array().abs() * inverse_) < kVoxelKeyLimit).all()) return;
    const Eigen::Array2i first = (center - reach).floor().cast<int>();
    const Eigen::Array2i last = (center + reach).floor().cast<int>();
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x) {
        const Eigen::Array2d corner(x, y), nearest = center.max(corner).min(corner + 1);
        if ((center - nearest).matrix().squaredNorm() <= reach * reach) visit(TileKey(x, y));
      }
  }

 private:
  static constexpr int kChunkShift = 10;
  static constexpr std::uint32_t kChunk = 1U << kChunkShift;

  double voxel_size_m_, inverse_;
  tsl::robin_map<std::uint64_t, std::uint32_t, BlockKeyHash> index_;
  tsl::robin_map<std::uint64_t, BlockTile, BlockKeyHash> tiles_;
  /// By index. Each chunk has its capacity from the start, so that blocks stay where they are.
  std::vector<std::vector<VoxelBlock>> chunks_;
  std::size_t block_count_ = 0;
  std::vector<std::uint32_t> free_;  ///< indices of erased blocks
  std::size_t voxel_count_ = 0;
};

}  // namespace stillmap
