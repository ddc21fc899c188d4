#include "rolling_map.hpp"

#include <algorithm>

#include "tile_packing.hpp"

namespace stillmap {
namespace {

/// A tile is left only when so many moves have not come near it; more than any memory of the last scans that
/// blocks keep (neighbourhood.cpp).
constexpr std::uint32_t kLingerMoves = 10;

/// Of many tiles that wait, so many are moved in one scan: a few scans share the work.
std::size_t share_of(std::size_t waiting) {
  return (waiting + 7) / 8;
}

std::uint32_t voxels_in(const std::vector<BlockContents>& blocks) {
  std::size_t voxels = 0;
  for (const BlockContents& block : blocks) voxels += block.voxels.size();
  return static_cast<std::uint32_t>(voxels);
}

}  // namespace

double RollingMap::distance_m(const TileKey& key, const Eigen::Vector3d& origin_map_m) const {
  const double tile_m = map_.block_size_m() * kTileEdge;
  const Eigen::Array2d corner = key.cast<double>().array() * tile_m;
  const Eigen::Array2d nearest = origin_map_m.head<2>().array().max(corner).min(corner + tile_m);
  return (origin_map_m.head<2>().array() - nearest).matrix().norm();
}

void RollingMap::move_to(const Eigen::Vector3d& origin_map_m) {
  ++moves_;
  map_.for_each_tile_near(origin_map_m, open_m_, [&](const TileKey& key) {
    auto [tile, is_new] = open_.try_emplace(packed_tile(key), OpenTile{key, moves_});
    tile.value().near_move = moves_;
    if (is_new) open(key);
  });
}

void RollingMap::leave(const Eigen::Vector3d& origin_map_m, std::uint32_t scan) {
  close_left(scan);
  if (memory_m_ > 0) move_away(origin_map_m);
}

void RollingMap::open(const TileKey& key) {
  const Tile tile = take(key);
  for (const BlockContents& block : tile.blocks) map_.restore(block, tile.scan);
}

void RollingMap::close_left(std::uint32_t scan) {
  std::vector<OpenTile> left;
  for (const auto& [packed_key, tile] : open_)
    if (tile.near_move + kLingerMoves < moves_) left.push_back(tile);
  const auto older = [](const OpenTile& a, const OpenTile& b) {
    return a.near_move != b.near_move ? a.near_move < b.near_move : packed_tile(a.key) < packed_tile(b.key);
  };
  std::sort(left.begin(), left.end(), older);
  left.resize(share_of(left.size()), OpenTile{});
  for (const OpenTile& tile : left) {
    pack_tile(tile.key, {scan, contents(tile.key, scan)});
    map_.erase_tile(tile.key);
    open_.erase(packed_tile(tile.key));
  }
}

void RollingMap::move_away(const Eigen::Vector3d& origin_map_m) {
  std::vector<TileKey> far;
  for (const auto& [packed_key, tile] : packed_)
    if (distance_m(tile.key, origin_map_m) > memory_m_) far.push_back(tile.key);
  far.resize(share_of(far.size()));
  for (const TileKey& key : far) {
    Tile tile = take(key);
    if (store_ != nullptr) store_->put(key, std::move(tile));
  }
}

void RollingMap::pack_tile(const TileKey& key, const Tile& tile) {
  if (tile.blocks.empty()) return;
  const std::uint32_t voxels = voxels_in(tile.blocks);
  packed_[packed_tile(key)] = {key, tile.scan, voxels, pack(tile.blocks)};
  packed_voxels_ += voxels;
}

Tile RollingMap::take(const TileKey& key) {
  const auto it = packed_.find(packed_tile(key));
  if (it == packed_.end()) return store_ != nullptr ? store_->get(key) : Tile{};
  Tile tile{it->second.scan, unpack(it->second.bytes)};
  packed_voxels_ -= it->second.voxels;
  packed_.erase(it);
  return tile;
}

}  // namespace stillmap
