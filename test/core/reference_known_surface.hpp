#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace stillmap::reference {

using Key = std::array<int, 3>;

inline double probability(double log_odds) {
  return 1 / (1 + std::exp(-log_odds));
}

/// A voxel in plain words; log-odds and surface are kept in the steps of the real one.
struct Voxel {
  double log_odds = 0;
  Eigen::Vector3d surface = Eigen::Vector3d::Constant(0.5);  ///< in voxel edges
  int born = 0, last_hit = 0, hits = 0;
  int seen_through = 0;  ///< scans
  bool moved_in = false;
  bool came_back = false;
};

/// Where surface is known to stand, and where it is porous: cells of 2 x 2 x 2 voxels, remembered for regions
/// of 8 x 8 x 8 voxels since a scan last hit one of them.
class KnownSurface {
 public:
  void update(const std::map<Key, Voxel>& voxels, int scan, double p_static_min) {
    std::set<Key> hit;
    for (const auto& [key, voxel] : voxels)
      if (voxel.last_hit == scan) hit.insert(shifted(key, 3));
    for (const Key& region : hit) regions_[region] = {scan, {}, {}};
    for (const auto& [key, voxel] : voxels) {
      if (hit.count(shifted(key, 3)) == 0) continue;
      Region& region = regions_[shifted(key, 3)];
      const bool stands = voxel.hits >= 3 && probability(voxel.log_odds) >= p_static_min;
      if (stands && scan - voxel.last_hit <= 1) region.standing.insert(shifted(key, 1));
      if (voxel.came_back && voxel.log_odds > 0) region.porous.insert(shifted(key, 1));
    }
  }

  /// Whether one of the 27 cells around the voxel's holds surface that stood in the last two scans.
  bool stands_beside(const Key& key, int scan) const {
    return any_around(key, [&](const Region& region, const Key& cell) {
      return scan - region.hit_scan <= 1 && region.standing.count(cell) > 0;
    });
  }
  bool is_porous_beside(const Key& key) const {
    return any_around(key,
                      [](const Region& region, const Key& cell) { return region.porous.count(cell) > 0; });
  }

 private:
  struct Region {
    int hit_scan = 0;
    std::set<Key> standing, porous;
  };

  static Key shifted(const Key& key, int bits) { return {key[0] >> bits, key[1] >> bits, key[2] >> bits}; }

  template <class Holds>
  bool any_around(const Key& key, Holds&& holds) const {
    const Key cell = shifted(key, 1);
    for (int i = 0; i < 27; ++i) {
      const Key near = {cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1};
      const auto region = regions_.find(shifted(near, 2));
      if (region != regions_.end() && holds(region->second, near)) return true;
    }
    return false;
  }

  std::map<Key, Region> regions_;
};

}  // namespace stillmap::reference
