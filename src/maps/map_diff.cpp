#include "maps/map_diff.hpp"

#include <tsl/robin_set.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "maps/map_index.hpp"
#include "stillmap/log_odds.hpp"

namespace stillmap {
namespace {

/// Calls visit(key, voxel) for each voxel of the map.
template <class Visitor>
void for_each(const MapContents& map, Visitor&& visit) {
  for (const BlockContents& block : map.blocks)
    for_each_voxel(block, [&](int place, const Voxel& voxel) { visit(voxel_key(block.key, place), voxel); });
}

/// True when visit(key) is for any key up to `reach` away along each axis, that itself included.
template <class Visitor>
bool any_around(const Eigen::Vector3i& middle, int reach, Visitor&& visit) {
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if (visit(Eigen::Vector3i(middle + Eigen::Vector3i(x, y, z)))) return true;
  return false;
}

/// One map as the other one sees it.
class OtherMap {
 public:
  OtherMap(const MapContents& map, const Decision& decision, const DiffOptions& options)
      : index_(map),
        decision_(decision),
        options_(options),
        reach_blocks_(
            static_cast<int>(std::ceil(options.mapped_within_m / (map.voxel_size_m * kBlockEdge)))) {}

  bool has_surface(const VoxelKey& key) const {
    const auto stands = [&](const VoxelKey& near) {
      const Voxel* voxel = index_.voxel(near);
      return voxel != nullptr && decision_(p_from_log_odds(voxel->log_odds())) != Label::kDynamic;
    };
    return stands(key) || any_around(key, options_.tolerance_voxels, stands);
  }
  bool was_around(const VoxelKey& key) const {
    return any_around(block_key(key), reach_blocks_,
                      [&](const BlockKey& near) { return index_.block(near) != nullptr; });
  }

 private:
  MapIndex index_;
  Decision decision_;
  DiffOptions options_;
  int reach_blocks_;
};

/// The static voxels of a map, sorted by what the other one has there.
struct Sorted {
  std::vector<VoxelKey> same, changed;
  std::size_t alone = 0;
};
Sorted sort(const MapContents& map, const OtherMap& other, const Decision& decision) {
  Sorted sorted;
  for_each(map, [&](const VoxelKey& key, const Voxel& voxel) {
    if (decision(p_from_log_odds(voxel.log_odds())) != Label::kStatic) return;
    if (other.has_surface(key))
      sorted.same.push_back(key);
    else if (other.was_around(key))
      sorted.changed.push_back(key);
    else
      ++sorted.alone;
  });
  return sorted;
}

/// The voxels in pieces that hang together over gaps of one voxel; the largest first.
std::vector<Change> connected(const std::vector<VoxelKey>& voxels, double voxel_size_m,
                              const DiffOptions& options) {
  constexpr int kGap = 2;
  tsl::robin_set<std::uint64_t, BlockKeyHash> left;
  for (const VoxelKey& key : voxels) left.insert(packed(key));
  std::vector<Change> changes;
  for (const VoxelKey& seed : voxels) {
    if (left.erase(packed(seed)) == 0) continue;
    Change change;
    change.voxels = {seed};
    for (std::size_t next = 0; next < change.voxels.size(); ++next) {
      const VoxelKey from = change.voxels[next];
      any_around(from, kGap, [&](const VoxelKey& near) {
        if (left.erase(packed(near)) > 0) change.voxels.push_back(near);
        return false;
      });
      change.extent_m.extend(from.cast<double>() * voxel_size_m);
      change.extent_m.extend((from.cast<double>().array() + 1).matrix() * voxel_size_m);
    }
    const bool is_high = change.extent_m.sizes().z() >= options.least_height_m;
    if (is_high && change.voxels.size() >= options.least_voxels) changes.push_back(std::move(change));
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.voxels.size() > b.voxels.size(); });
  return changes;
}

}  // namespace

MapDiff diff(const MapContents& first, const MapContents& second, const Decision& decision,
             const DiffOptions& options) {
  if (first.voxel_size_m != second.voxel_size_m)
    throw std::invalid_argument("voxels of " + std::to_string(first.voxel_size_m) + " m and of " +
                                std::to_string(second.voxel_size_m) +
                                " m cannot be compared; make both maps with one voxel_size_m");
  const Sorted before = sort(first, OtherMap(second, decision, options), decision);
  Sorted now = sort(second, OtherMap(first, decision, options), decision);
  MapDiff result;
  result.voxel_size_m = second.voxel_size_m;
  result.gone = connected(before.changed, result.voxel_size_m, options);
  result.appeared = connected(now.changed, result.voxel_size_m, options);
  result.same = std::move(now.same);
  result.only_first = before.alone;
  result.only_second = now.alone;
  return result;
}

}  // namespace stillmap
