#pragma once

#include <map>
#include <utility>

#include "stillmap/tile_store.hpp"

namespace stillmap {

class TilesInATable : public TileStore {
 public:
  void put(const TileKey& key, Tile tile) override { tiles_[packed_tile(key)] = {key, std::move(tile)}; }
  Tile get(const TileKey& key) override {
    const auto it = tiles_.find(packed_tile(key));
    return it == tiles_.end() ? Tile{} : it->second.second;
  }
  std::vector<TileKey> keys() const override {
    std::vector<TileKey> keys;
    for (const auto& [packed_key, entry] : tiles_) keys.push_back(entry.first);
    return keys;
  }
  void clear() override { tiles_.clear(); }

 private:
  std::map<std::uint64_t, std::pair<TileKey, Tile>> tiles_;
};

}  // namespace stillmap
